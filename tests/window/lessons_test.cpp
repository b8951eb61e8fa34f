// The lessons in the window, under SDL's dummy driver: each opened, its controls moved by events,
// and the pictures in the window's pixels held against those that the lesson draws.

#include <gtest/gtest.h>

#include <memory>
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
