// The window itself, under SDL's dummy driver, driven by events as SDL makes them.

#include "apps/demo/window/window.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "apps/demo/window/command_line.h"
#include "apps/demo/window/light_handles.h"
#include "apps/scanlight/picture.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/scene_setup.h"
#include "raster/compare.h"
#include "raster/save_image.h"

namespace scanlight::apps::window {
namespace {

// ---- a person at the window

class Person {
public:
    explicit Person(const std::string& command_line)
        : window_(parse_scene(command_line + " --size 500x900")) {
        look();
    }

    Window& window() { return window_; }
    const WindowState& state() const { return window_.state(); }

    void look() {
        for (int i = 0; i < 4; ++i)
            window_.step();
    }
    void move(Point to) {
        SDL_Event event{};
        event.type = SDL_MOUSEMOTION;
        event.motion.x = static_cast<int>(to.x);
        event.motion.y = static_cast<int>(to.y);
        push(event);
    }
    void press(Point at) { button(SDL_MOUSEBUTTONDOWN, at); }
    void release(Point at) { button(SDL_MOUSEBUTTONUP, at); }
    void drag(Point from, Point to) {
        move(from);
        press(from);
        move(to);
        release(to);
    }
    void click(Point at) { drag(at, at); }
    void wheel(Point at, int notches) {
        move(at);
        SDL_Event event{};
        event.type = SDL_MOUSEWHEEL;
        event.wheel.y = notches;
        push(event);
    }
    void type(SDL_Keycode key) {
        SDL_Event event{};
        event.type = SDL_KEYDOWN;
        event.key.keysym.sym = key;
        push(event);
        event.type = SDL_KEYUP;
        push(event);
    }
    void drop(const std::string& path) {
        SDL_Event event{};
        event.type = SDL_DROPFILE;
        event.drop.file = SDL_strdup(path.c_str());
        push(event);
    }

    /// The one there is.
    static SDL_Window* sdl_window() {
        for (Uint32 id = 1; id < 1000; ++id) {
            if (SDL_Window* window = SDL_GetWindowFromID(id)) return window;
        }
        return nullptr;
    }

    Box control(const std::string& name) const {
        const auto found = window_.controls().find(name);
        EXPECT_NE(found, window_.controls().end()) << name;
        return found == window_.controls().end() ? Box{} : found->second;
    }
    /// A place on it, as a share of its width.
    Point place_on(const std::string& name, double share) const {
        const Box box = control(name);
        return {box.x + share * box.width, box.y + box.height / 2.0};
    }
    void click_on(const std::string& name) { click(place_on(name, 0.5)); }
    void slide(const std::string& name, double from, double to) {
        drag(place_on(name, from), place_on(name, to));
    }
    /// A word of an open list, by its place in it.
    void choose(const std::string& name, int word) {
        const Box box = control(name);
        click_on(name);
        click({box.x + 30.0, box.y + box.height + 14.0 + 20.0 * word});
    }

private:
    void push(SDL_Event event) {
        SDL_PushEvent(&event);
        look();
    }
    void button(Uint32 type, Point at) {
        SDL_Event event{};
        event.type = type;
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = static_cast<int>(at.x);
        event.button.y = static_cast<int>(at.y);
        push(event);
    }

    Window window_;
};

class LiveWindow : public testing::Test {
protected:
    static void SetUpTestSuite() { setenv("SDL_VIDEODRIVER", "dummy", 1); }

    /// What the program draws for a command line.
    static raster::Image8 drawn_by(const std::string& arguments) {
        const SceneOptions options = parse_scene(arguments);
        const Models models = load_models(options);
        return byte_image(draw_picture(scene_of(models, options), options, {}, {}),
                          raster::Alpha::dropped);
    }

    /// That the window shows of a view just what the program draws for its command line.
    static void expect_as_by_command_line(Person& person, View view) {
        const std::string arguments = arguments_of(person.state().of(view));
        ASSERT_FALSE(arguments.empty());
        const auto shown = image_of(person.window().painter(view).pixels(), raster::Alpha::dropped);
        EXPECT_TRUE(shown == drawn_by(arguments)) << arguments;
    }

    /// That part of the window's pixels.
    static raster::Image8 part(const raster::Image8& image, const Box& box) {
        raster::Image8 result(box.width, box.height, 3);
        for (int y = 0; y < box.height; ++y) {
            const auto row = image.row(box.y + y).subspan(static_cast<std::size_t>(3 * box.x),
                                                          static_cast<std::size_t>(3 * box.width));
            std::ranges::copy(row, result.row(y).begin());
        }
        return result;
    }

    /// For a person to look at, where asked for.
    static void keep(Person& person, const std::string& name) {
        if (const char* folder = std::getenv("SCANLIGHT_SCREENSHOTS"))
            raster::save_image(std::string(folder) + "/" + name + ".png",
                               person.window().screenshot());
    }
};

// ---- pictures

TEST_F(LiveWindow, ShowsThePicturePixelForPixel) {
    Person person("sphere:16,8");
    const Box without_marks{0, 420, 500, 400};  // beneath the name and the light's disc
    const auto shown = part(person.window().screenshot(), without_marks);
    EXPECT_TRUE(shown == part(drawn_by("sphere:16,8 --size 500x900"), without_marks));
    keep(person, "one");
}

TEST_F(LiveWindow, ASliderMakesThePictureThatItsCommandLineDraws) {
    Person person("sphere:16,8");
    const std::string before = person.window().painter(View::left).drawn();
    for (const std::string name : {"exponent", "specular", "diffuse", "transparency"})
        person.slide(name, 0.5, 0.7);
    EXPECT_NE(person.window().painter(View::left).drawn(), before);
    EXPECT_TRUE(person.state().current().material.exponent);
    EXPECT_TRUE(person.state().current().material.opacity);
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, ChoicesSwitchWhileItRuns) {
    Person person("torus:16,8 --floor");
    person.choose("shading", 0);
    EXPECT_EQ(person.state().current().settings.shading, render::Shading::flat);
    person.choose("illumination", 3);
    EXPECT_EQ(person.state().current().settings.illumination, shading::Illumination::blinn);
    person.choose("interpolation", 1);
    EXPECT_EQ(person.state().current().polygons, Polygons::triangulated);
    person.choose("shadows", 3);
    EXPECT_EQ(person.state().current().settings.shadows, render::Shadows::zfail);
    expect_as_by_command_line(person, View::left);
    keep(person, "choices");
}

TEST_F(LiveWindow, FacetsHaveTheirOwnSliders) {
    Person person("teapot --illumination cook-torrance --metal gold");
    person.slide("roughness", 0.3, 0.6);
    EXPECT_TRUE(person.state().current().material.facets.roughness);
    EXPECT_FALSE(person.window().controls().contains("exponent"));
    expect_as_by_command_line(person, View::left);
    keep(person, "facets");
}

TEST_F(LiveWindow, TheMouseTurnsAndZoomsToAPictureThatACommandLineDraws) {
    Person person("teapot");
    person.drag({100, 600}, {160, 570});
    person.wheel({100, 600}, 2);
    ASSERT_TRUE(person.state().current().eye);
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, ALightIsDraggedInThePicture) {
    Person person("teapot");
    const auto camera = person.window().painter(View::left).scene().camera;
    const auto handle = light_handles(person.state().current(), camera, {0, 0, 500, 900}).at(0).at;
    person.drag(handle, {350, 500});
    ASSERT_EQ(person.state().current().lights.size(), 1u);
    EXPECT_GT(person.state().current().lights[0].place.x, 0.0);
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, ALampIsAddedAndColoured) {
    Person person("teapot --floor --shadows zfail");
    person.wheel({700, 500}, -60);
    person.click_on("add lamp");
    ASSERT_EQ(person.state().current().lights.size(), 2u);
    EXPECT_EQ(person.state().current().lights[1].frame, LightFrame::point);
    person.slide("light 2", 0.8, 0.3);
    EXPECT_LT(person.state().current().lights[1].color.r, 0.7f);
    expect_as_by_command_line(person, View::left);
    person.wheel({700, 500}, -60);  // the list is longer now
    keep(person, "lamp");
    person.click_on("remove light");
    EXPECT_EQ(person.state().current().lights.size(), 1u);
}

TEST_F(LiveWindow, TexturesArePutOnWhileItRuns) {
    Person person("teapot");
    person.wheel({700, 500}, -60);
    person.click_on("Textures");
    person.wheel({700, 500}, -60);
    person.choose("diffuse texture", 6);
    EXPECT_EQ(person.state().current().textures.size(), 1u);
    expect_as_by_command_line(person, View::left);
    keep(person, "texture");
}

// ---- two views

TEST_F(LiveWindow, TwoViewsKeepTheirOwnSettings) {
    Person person("teapot");
    person.click_on("Wipe");
    person.click_on("View B");
    person.choose("shading", 0);
    EXPECT_EQ(person.state().of(View::left).settings.shading, render::Shading::phong);
    EXPECT_EQ(person.state().of(View::right).settings.shading, render::Shading::flat);
    expect_as_by_command_line(person, View::left);
    expect_as_by_command_line(person, View::right);
    keep(person, "wipe");
}

TEST_F(LiveWindow, TheDividerShowsMoreOfOneView) {
    Person person("teapot");
    person.type(SDLK_3);
    keep(person, "beside");
    person.drag({250, 850}, {150, 850});
    EXPECT_EQ(divider_column(person.state()), 150);
    expect_as_by_command_line(person, View::left);
    expect_as_by_command_line(person, View::right);
}

TEST_F(LiveWindow, ADifferenceHasTheNumbersOfDiff) {
    Person person("teapot");
    person.click_on("Difference");
    ASSERT_TRUE(person.window().contrast());
    EXPECT_EQ(person.window().contrast()->difference.different_pixels, 0);
    person.choose("shading", 1);
    const auto expected = raster::compare(drawn_by("teapot --size 500x900 --shading gouraud"),
                                          drawn_by("teapot --size 500x900"));
    const auto& found = person.window().contrast()->difference;
    EXPECT_GT(found.different_pixels, 0);
    EXPECT_EQ(found.different_pixels, expected.different_pixels);
    EXPECT_EQ(found.mean_absolute, expected.mean_absolute);
    keep(person, "difference");
}

// ---- the rest

TEST_F(LiveWindow, ABuiltInShapeIsChosen) {
    Person person("teapot --shading flat");
    person.choose("shape", 1);
    EXPECT_NE(person.state().current().objects.at(0).input, "teapot");
    EXPECT_EQ(person.state().current().settings.shading, render::Shading::flat);
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, AFileIsTakenByDrop) {
    Person person("teapot");
    person.drop(SCANLIGHT_TESTS_DIR "/data/crate.obj");
    EXPECT_EQ(person.state().current().objects.at(0).input, SCANLIGHT_TESTS_DIR "/data/crate.obj");
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, WhatCannotBeLoadedLeavesAllAsItWas) {
    Person person("teapot");
    person.drop("no-such-mesh.obj");
    EXPECT_EQ(person.state().current().objects.at(0).input, "teapot");
    EXPECT_NE(person.window().message().find("no-such-mesh.obj"), std::string::npos);
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, TheLoupeTellsOfThePixelUnderTheMouse) {
    Person person("teapot --shadows zfail --floor --light point:2,3,2");
    person.type(SDLK_l);
    person.move({250, 480});
    const auto picked = picked_pixel(person.state());
    ASSERT_TRUE(picked);
    EXPECT_EQ(picked->x, 250);
    EXPECT_EQ(picked->y, 480);
    keep(person, "loupe");
}

TEST_F(LiveWindow, TheSameEventsMakeTheSamePixels) {
    const auto seen = [] {
        Person person("teapot");
        person.click_on("Wipe");
        person.slide("diffuse", 0.5, 0.3);
        // Milliseconds are never the same.
        return part(person.window().screenshot(), {0, 0, 500, 900});
    };
    EXPECT_TRUE(seen() == seen());
}

TEST_F(LiveWindow, DrawsNothingWhereNothingHappens) {
    Person person("teapot");
    EXPECT_FALSE(person.window().step());
}

TEST_F(LiveWindow, TakesItsSizeFromTheSystem) {
    Person person("teapot");
    EXPECT_EQ(person.state().canvas.width, 500);
    SDL_SetWindowSize(person.sdl_window(), 700 + Panel::width, 600);
    person.move({5, 5});
    EXPECT_EQ(person.state().canvas.width, 700);
    EXPECT_EQ(person.state().canvas.height, 600);
    expect_as_by_command_line(person, View::left);
}

}  // namespace
}  // namespace scanlight::apps::window
