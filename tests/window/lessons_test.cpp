// The lessons in the window, under SDL's dummy driver: each opened, its controls moved by events,
// and the pictures in the window's pixels held against those that the lesson draws.

#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>

#include "apps/demo/settings.h"
#include "tests/window/person.h"

namespace scanlight::apps::window {
namespace {

constexpr const char* canvas = "960x720";

class LessonWindow : public WindowTest {
protected:
    /// That the window's pixels are those that the lesson draws by itself, marks and all.
    static void expect_as_drawn(Person& person) {
        const LessonState& state = person.state().lesson;
        const auto& boxes = person.window().lesson_view().sight().pictures;
        const auto& panels = person.window().lesson_view().screen().panels;
        ASSERT_EQ(boxes.size(), panels.size());
        const demo::Screen screen = state.lesson().draw(state.settings, asked_size(person), {});
        const raster::Image8 shown = person.window().screenshot();
        for (std::size_t i = 0; i < boxes.size(); ++i)
            EXPECT_TRUE(part(shown, boxes[i]) == demo::marked(screen.panels[i]))
                << state.lesson().name << ", panel " << i << ": " << command_of(state);
    }

    /// That they are those that the command under the pictures draws.
    static void expect_as_by_command_line(Person& person) {
        const LessonState& state = person.state().lesson;
        demo::Settings settings = demo::starting_settings(state.lesson());
        std::istringstream words(
            command_of(as_shown(state, person.window().lesson_view().screen())));
        for (std::string word, before; words >> word; before = word) {
            if (before == "--set") demo::set(settings, state.lesson(), word);
        }
        const demo::Screen screen = state.lesson().draw(settings, asked_size(person), {});
        EXPECT_TRUE(demo::picture_of(screen) ==
                    demo::picture_of(person.window().lesson_view().screen()))
            << words.str();
    }

    static raster::Viewport asked_size(const Person& person) {
        return person.window().lesson_view().sight().panel;
    }

    static void open(Person& person, std::size_t place) {
        person.choose("lessons", static_cast<int>(place) + 1);  // below the free view
        ASSERT_EQ(person.state().lesson.place, place);
    }

    static double value(const Person& person, const std::string& control) {
        return person.state().lesson.settings.at(control);
    }

    static void move_first_control(Person& person) {
        const demo::Control& control = person.state().lesson.lesson().controls.front();
        const double before = value(person, control.name);
        if (std::holds_alternative<demo::Slider>(control.kind)) {
            person.slide(control.name, 0.3, 0.7);
        } else {
            person.choose(control.name, before == 0.0 ? 1 : 0);
        }
        EXPECT_NE(value(person, control.name), before) << control.name;
    }
};

class EachLesson : public LessonWindow, public testing::WithParamInterface<std::size_t> {};

TEST_P(EachLesson, ShowsWhatTheLessonDraws) {
    Person person("teapot", canvas);
    open(person, GetParam());
    const std::string& name = person.state().lesson.lesson().name;
    expect_as_drawn(person);
    keep(person, "lesson-" + name);
    move_first_control(person);
    expect_as_drawn(person);
    person.click_on("language");
    expect_as_drawn(person);
    keep(person, "lesson-" + name + "-zh");
}

TEST_P(EachLesson, AnswersItsQuestion) {
    Person person("teapot", canvas);
    open(person, GetParam());
    person.type(SDLK_a);
    EXPECT_EQ(person.state().lesson.answer, Answer::shown);
    person.wheel({1200.0, 500.0}, -60);
    keep(person, "answer-" + person.state().lesson.lesson().name);
}

std::string test_name(const testing::TestParamInfo<std::size_t>& info) {
    std::string name = demo::lessons()[info.param].name;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Lessons, EachLesson,
                         testing::Range(std::size_t{0}, demo::lessons().size()), test_name);

TEST_F(LessonWindow, LeadsThroughTheCourse) {
    Person person("teapot", canvas);
    open(person, 2);
    EXPECT_EQ(person.state().subject, Subject::lesson);
    EXPECT_EQ(person.state().lesson.lesson().name, "lost-highlight");
    person.click_on("next");
    EXPECT_EQ(person.state().lesson.lesson().name, "orientation");
    person.click_on("previous");
    expect_as_drawn(person);
    person.click_on("free view");
    EXPECT_EQ(person.state().subject, Subject::scene);
    person.type(SDLK_c);
    EXPECT_EQ(person.state().lesson.lesson().name, "lost-highlight");
    expect_as_drawn(person);
}

TEST_F(LessonWindow, StepsThroughTheEdgeTableByButtons) {
    Person person("teapot", canvas);
    open(person, 0);
    const double start = value(person, "step");
    person.click_on("next-step");
    EXPECT_EQ(value(person, "step"), start + 1);
    person.click_on("back-step");
    person.click_on("back-step");
    EXPECT_EQ(value(person, "step"), start - 1);
    person.click_on("next-scanline");
    EXPECT_GE(value(person, "step"), start);
    expect_as_drawn(person);
    person.click_on("first-step");
    EXPECT_EQ(value(person, "step"), 0.0);
    person.click_on("last-step");
    expect_as_drawn(person);
    keep(person, "edge-table-end");
}

TEST_F(LessonWindow, ThePictureItselfIsAControl) {
    for (const auto& [name, control] :
         {std::pair{"mach-bands", "cut"}, {"cook-torrance", "y"}, {"shadow-volumes", "y"}}) {
        Person person("teapot", canvas);
        open(person, opened(name, demo::Language::english).place);
        const Box box = person.window().lesson_view().sight().pictures.front();
        const Point low{box.x + 0.4 * box.width, box.y + 0.3 * box.height};
        person.drag(low, {low.x, box.y + 0.6 * box.height});
        EXPECT_NEAR(value(person, control), 0.6, 0.01) << name;
        expect_as_drawn(person);
        keep(person, std::string("pointed-") + name);
    }
}

TEST_F(LessonWindow, ACornerOfThePolygonIsDragged) {
    Person person("teapot", canvas);
    open(person, 0);
    const double cell = person.window().lesson_view().sight().pictures.front().width / 24.0;
    const Point at = person.place_on("corner 1", 0.0);
    person.drag(at, {at.x + 2 * cell, at.y - 3 * cell});
    EXPECT_EQ(command_of(person.state().lesson),
              "scanlight-demo --lesson edge-table --set "
              "corners=0.1,1.12:-1.3,0.68:-0.1,-1.12:1.6,-0.28");
    keep(person, "corner-dragged");
    person.click({at.x, 715.0});  // lets the corner go, and its ring
    expect_as_drawn(person);
    expect_as_by_command_line(person);
    person.click_on("put back");
    EXPECT_EQ(command_of(person.state().lesson), "scanlight-demo --lesson edge-table");
    expect_as_drawn(person);
}

TEST_F(LessonWindow, ACornerIsMovedByKeys) {
    Person person("teapot", canvas);
    open(person, 0);
    person.type(SDLK_TAB);
    for (int i = 0; i < 3; ++i)
        person.type(SDLK_DOWN, KMOD_LSHIFT);
    person.type(SDLK_LEFT, KMOD_LSHIFT);
    keep(person, "corner-by-keys");
    EXPECT_EQ(command_of(person.state().lesson),
              "scanlight-demo --lesson edge-table --set "
              "corners=0.05,1:-1.7,0.2:-0.1,-1.12:1.6,-0.28");
    person.click({200.0, 715.0});
    expect_as_by_command_line(person);
}

TEST_F(LessonWindow, ACornerIsNotDraggedToWhereNothingIsFilled) {
    Person person("teapot", canvas);
    open(person, 0);
    person.choose("polygon", 0);
    const Point last = person.place_on("corner 2", 0.0);
    const Point first = person.place_on("corner 0", 0.0);
    person.drag(last, first);
    EXPECT_NE(person.window().message().find("no area"), std::string::npos)
        << person.window().message();
    EXPECT_EQ(command_of(person.state().lesson),
              "scanlight-demo --lesson edge-table --set "
              "polygon=triangle");
}

TEST_F(LessonWindow, ItsCommandIsCopied) {
    Person person("teapot", canvas);
    open(person, 1);
    person.slide("cut", 0.3, 0.8);
    person.wheel({1200.0, 500.0}, -60);
    person.click_on("copy 0");
    const std::unique_ptr<char, void (*)(void*)> copied(SDL_GetClipboardText(), SDL_free);
    EXPECT_EQ(std::string(copied.get()), command_of(person.state().lesson, asked_size(person)));
}

TEST_F(LessonWindow, FitsASmallerWindow) {
    Person person("teapot", "640x480");
    open(person, 8);
    expect_as_drawn(person);
    keep(person, "small");
}

TEST_F(LessonWindow, DrawsNothingWhereNothingHappens) {
    Person person("teapot", canvas);
    open(person, 0);
    EXPECT_FALSE(person.window().step());
}

}  // namespace
}  // namespace scanlight::apps::window
