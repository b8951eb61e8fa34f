// The window itself, under SDL's dummy driver, driven by events as SDL makes them.

#include "apps/demo/window/window.h"

#include <gtest/gtest.h>

#include "apps/demo/window/command_line.h"
#include "apps/demo/window/light_handles.h"
#include "apps/scanlight/picture.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/scene_setup.h"
#include "raster/compare.h"
#include "tests/window/person.h"

namespace scanlight::apps::window {
namespace {

class LiveWindow : public WindowTest {
protected:
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

TEST_F(LiveWindow, AFileDroppedOnALessonIsSeenOrRefusedAtOnce) {
    Person person("teapot");
    person.type(SDLK_c);
    ASSERT_EQ(person.state().subject, Subject::lesson);
    person.drop("no-such-mesh.obj");
    EXPECT_EQ(person.state().subject, Subject::lesson);
    person.type(SDLK_ESCAPE);
    EXPECT_EQ(person.state().subject, Subject::scene);
    expect_as_by_command_line(person, View::left);
    person.type(SDLK_c);
    person.drop(SCANLIGHT_TESTS_DIR "/data/crate.obj");
    EXPECT_EQ(person.state().subject, Subject::scene);
    expect_as_by_command_line(person, View::left);
}

TEST_F(LiveWindow, AMessageGoesWhenSomethingElseIsDone) {
    Person person("teapot");
    person.drop("no-such-mesh.obj");
    EXPECT_NE(person.window().message(), "");
    person.type(SDLK_l);
    EXPECT_EQ(person.window().message(), "");
}

TEST_F(LiveWindow, AKeyHeldTooLongSwitchesOnce) {
    Person person("teapot");
    person.hold(SDLK_l, 3);
    EXPECT_EQ(person.state().loupe, Loupe::open);
}

TEST_F(LiveWindow, TheLoupeHasNoPixelWhereTheMouseHasLeft) {
    Person person("teapot");
    person.type(SDLK_l);
    person.move({250, 480});
    EXPECT_TRUE(picked_pixel(person.state()));
    person.leave();
    EXPECT_FALSE(picked_pixel(person.state()));
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

TEST_F(LiveWindow, TheLoupeTellsOfTexturesAndFacets) {
    Person person(
        "sphere --illumination cook-torrance --roughness 0.3 --material ks=0.5 "
        "--texture diffuse=checker --texture bump=waves",
        "600x900");
    person.type(SDLK_l);
    person.move({280, 480});
    const auto& painter = person.window().painter(View::left);
    const auto pixel = PixelReader().at(painter, person.state().current(), 280, 480);
    ASSERT_TRUE(pixel);
    EXPECT_EQ(pixel->textures.size(), 2u);
    ASSERT_TRUE(pixel->lights.front().facets);
    EXPECT_GT(pixel->lights.front().facets->D, 0.0f);
    keep(person, "loupe-textures");
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
