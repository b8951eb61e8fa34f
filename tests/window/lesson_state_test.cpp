// A lesson in the window as a value, and what events make of it: no window is needed.

#include "apps/demo/window/lesson_state.h"

#include <gtest/gtest.h>

#include "apps/demo/settings.h"
#include "apps/demo/window/corner_handles.h"
#include "apps/demo/window/lesson_events.h"
#include "apps/demo/window/lesson_layout.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps::window {
namespace {

constexpr demo::Language english = demo::Language::english;

demo::Screen screen_of(const LessonState& state) {
    return state.lesson().draw(state.settings, {72, 54}, Means{DrawPath::fast, {1, {}}});
}

WindowState showing(const std::string& lesson) {
    return with_lesson({}, opened(lesson, english));
}

/// After events over pictures that stand side by side, each of 100 x 80 pixels.
WindowState after_all(WindowState state, const std::vector<Event>& events) {
    for (const Event& event : events) {
        const demo::Screen screen = screen_of(state.lesson);
        std::vector<Box> pictures;
        for (std::size_t i = 0; i < screen.panels.size(); ++i)
            pictures.push_back({static_cast<int>(i) * 100, 0, 100, 80});
        state = after_in_lesson(std::move(state), event, {screen, pictures, {100, 80}});
    }
    return state;
}

/// Where a corner is in such pictures.
Point corner_place(const WindowState& state, std::size_t corner) {
    const demo::Screen screen = screen_of(state.lesson);
    return corner_places(state.lesson, {screen, {{0, 0, 100, 80}}, {100, 80}}).at(corner);
}

/// Of the grid, in pixels of the picture.
constexpr double cell = 3.0;

std::string corners_of(const WindowState& state) {
    const demo::Lesson& lesson = state.lesson.lesson();
    return demo::text_of(demo::control_named(lesson, "corners"), state.lesson.settings);
}

constexpr const char* quad = "0.1,1.12:-1.7,0.2:-0.1,-1.12:1.6,-0.28";

double step_of(const WindowState& state) {
    return state.lesson.settings.at("step");
}

TEST(LessonState, OpensByName) {
    EXPECT_EQ(opened("mach-bands", english).place, 1u);
    EXPECT_EQ(opened("mach-bands", english).settings.at("cut"), 0.4);
    EXPECT_THROW(opened("no-such", english), UsageError);
}

TEST(LessonState, NextAndPreviousEndWithTheCourse) {
    LessonState state = opened(0, demo::Language::chinese);
    EXPECT_EQ(with_previous(state).place, 0u);
    for (std::size_t i = 0; i < 2 * demo::lessons().size(); ++i)
        state = with_next(std::move(state));
    EXPECT_EQ(state.place, demo::lessons().size() - 1);
    EXPECT_EQ(state.language, demo::Language::chinese);
}

TEST(LessonState, ForwardAndBackGoFromStopToStop) {
    LessonState state = opened("lost-highlight", english);
    const demo::Screen screen = screen_of(state);
    state = moved(std::move(state), Way::first, screen);
    EXPECT_EQ(state.settings.at("level"), 0.0);
    state.settings["level"] = 0.6;  // between two
    EXPECT_EQ(moved(state, Way::forward, screen).settings.at("level"), 1.0);
    EXPECT_EQ(moved(state, Way::back, screen).settings.at("level"), 0.0);
    EXPECT_EQ(moved(state, Way::last, screen).settings.at("level"), 5.0);
}

TEST(LessonState, AWalkIsTakenBackAsItWent) {
    LessonState state = opened("edge-table", english);
    const demo::Screen screen = screen_of(state);
    for (const auto& [there, back] :
         {std::pair{Way::forward, Way::back}, {Way::scanline_forward, Way::scanline_back}}) {
        state = moved(std::move(state), Way::first, screen);
        std::vector<double> steps;
        while (steps.empty() || state.settings.at("step") != steps.back()) {
            steps.push_back(state.settings.at("step"));
            state = moved(std::move(state), there, screen);
        }
        EXPECT_EQ(steps.back(), last_value(state.lesson().controls.front(), screen));
        EXPECT_GT(steps.size(), 8u);
        if (there == Way::scanline_forward) continue;  // its last is in the middle of a scanline
        for (std::size_t i = steps.size() - 1; i-- > 0;) {
            state = moved(std::move(state), back, screen);
            EXPECT_EQ(state.settings.at("step"), steps[i]);
        }
    }
}

TEST(LessonState, ScanlineStepsEnterScanlines) {
    LessonState state = opened("edge-table", english);
    const demo::Screen screen = screen_of(state);
    for (const Way way : {Way::scanline_forward, Way::scanline_back}) {
        state = moved(std::move(state), way, screen);
        EXPECT_EQ(step_shown(state, screen)->kind, demo::WalkStep::Kind::scanline);
    }
}

TEST(LessonState, ItsCommandIsThatOfItsScreen) {
    LessonState state = opened("mach-bands", english);
    EXPECT_EQ(command_of(state), "scanlight-demo --lesson mach-bands");
    state = with_control(std::move(state), state.lesson().controls[0], 0.55555);
    EXPECT_EQ(command_of(state), "scanlight-demo --lesson mach-bands --set cut=0.556");
    demo::Settings again = demo::starting_settings(state.lesson());
    demo::set(again, state.lesson(), "cut=0.556");
    EXPECT_EQ(again, state.settings);
}

TEST(LessonState, ControlsKeepToTheirRange) {
    LessonState state = opened("mach-bands", english);
    const demo::Control& cut = state.lesson().controls[0];
    EXPECT_EQ(with_control(state, cut, 7.0).settings.at("cut"), 0.9);
    EXPECT_EQ(with_control(state, cut, -7.0).settings.at("cut"), 0.1);
}

// ---- events

TEST(LessonEvents, TheCutLineFollowsTheMouse) {
    WindowState state = after_all(showing("mach-bands"), {Press{{150.0, 40.0}}});
    EXPECT_NEAR(state.lesson.settings.at("cut"), 40.5 / 80, 5e-4);
    state = after_all(std::move(state), {Move{{150.0, 60.0}}});
    EXPECT_NEAR(state.lesson.settings.at("cut"), 60.5 / 80, 5e-4);
    state = after_all(std::move(state), {Move{{150.0, 500.0}}, Release{}, Move{{150.0, 20.0}}});
    EXPECT_EQ(state.lesson.settings.at("cut"), 0.9);
}

TEST(LessonEvents, AClickPicksThePixelUnderIt) {
    for (const std::string lesson : {"cook-torrance", "shadow-volumes"}) {
        const WindowState state = after_all(showing(lesson), {Press{{150.0, 24.0}}, Release{}});
        EXPECT_NEAR(state.lesson.settings.at("x"), 0.505, 1e-3);
        EXPECT_NEAR(state.lesson.settings.at("y"), 24.5 / 80, 1e-3);
    }
}

TEST(LessonEvents, ElsewhereThereIsNothingToPointAt) {
    const WindowState state = showing("phong-terms");
    EXPECT_EQ(after_all(state, {Press{{50.0, 40.0}}, Release{}}).lesson.settings,
              state.lesson.settings);
    const WindowState cut = showing("mach-bands");
    EXPECT_EQ(after_all(cut, {Press{{50.0, 200.0}}, Release{}}).lesson.settings,
              cut.lesson.settings);
}

TEST(LessonEvents, ACornerIsDragged) {
    WindowState state = showing("edge-table");
    ASSERT_EQ(corners_of(state), quad);
    const Point at = corner_place(state, 1);
    const Point beside{at.x + 2.0, at.y - 1.0};
    state = after_all(std::move(state), {Press{beside}});
    EXPECT_EQ(corners_of(state), quad) << "a press moves nothing";
    EXPECT_TRUE(state.lesson.settings.corners.empty());
    state = after_all(std::move(state), {Move{{beside.x + 2 * cell, beside.y + cell}}});
    EXPECT_EQ(corners_of(state), "0.1,1.12:-1.3,0.04:-0.1,-1.12:1.6,-0.28");
    state = after_all(std::move(state), {Release{}, Move{at}});
    EXPECT_EQ(corners_of(state), "0.1,1.12:-1.3,0.04:-0.1,-1.12:1.6,-0.28");
    EXPECT_EQ(command_of(state.lesson),
              "scanlight-demo --lesson edge-table --set "
              "corners=0.1,1.12:-1.3,0.04:-0.1,-1.12:1.6,-0.28");
}

TEST(LessonEvents, ACornerStaysInTheGridAndAtQuartersOfAPixel) {
    WindowState state = showing("edge-table");
    const Point at = corner_place(state, 1);
    state = after_all(std::move(state), {Press{at}, Move{{-900.0, -900.0}}});
    EXPECT_EQ(corners_of(state), "0.1,1.12:-2.35,1.24:-0.1,-1.12:1.6,-0.28");
    state = after_all(std::move(state), {Move{{at.x + 0.13 * cell, at.y - 0.12 * cell}}});
    EXPECT_EQ(corners_of(state), "0.1,1.12:-1.65,0.2:-0.1,-1.12:1.6,-0.28");
}

TEST(LessonEvents, OnlyTheLeftButtonNearACornerTakesIt) {
    const WindowState state = showing("edge-table");
    const Point at = corner_place(state, 1);
    for (const Press& press : {Press{at, Button::right}, Press{{at.x + 14.0, at.y}}}) {
        const WindowState after = after_all(state, {press, Move{{40.0, 40.0}}});
        EXPECT_EQ(corners_of(after), quad);
        EXPECT_EQ(after.lesson.corner, std::nullopt);
    }
}

TEST(LessonEvents, KeysMoveTheCornerThatWasTouched) {
    WindowState state = after_all(showing("edge-table"), {Nudge{1, 0}});
    EXPECT_EQ(corners_of(state), quad) << "none was";
    state = after_all(std::move(state), {Key{'\t'}, Key{'\t'}, Nudge{1, 0}, Nudge{0, -1}});
    EXPECT_EQ(corners_of(state), "0.1,1.12:-1.65,0.16:-0.1,-1.12:1.6,-0.28");
    const double start = step_of(state);
    state = after_all(std::move(state), {NamedKey::right});
    EXPECT_EQ(step_of(state), start + 1) << "arrows alone step";
    state = after_all(std::move(state), {Key{'\t'}, Key{'\t'}, Key{'\t'}, Nudge{1, 0}});
    EXPECT_EQ(state.lesson.corner, std::nullopt) << "after the last";
    EXPECT_EQ(corners_of(state), "0.1,1.12:-1.65,0.16:-0.1,-1.12:1.6,-0.28");
}

TEST(LessonEvents, CornersGoBackByThemselvesAndByAnotherPolygon) {
    const WindowState moved =
        after_all(showing("edge-table"), {Key{'\t'}, Nudge{1, 0}, Nudge{1, 0}});
    ASSERT_NE(corners_of(moved), quad);
    const auto& controls = moved.lesson.lesson().controls;
    WindowState back = moved;
    back.lesson =
        with_corners_back(back.lesson, demo::control_named(back.lesson.lesson(), "corners"));
    EXPECT_EQ(corners_of(back), quad);
    WindowState other = moved;
    other.lesson = with_control(other.lesson, controls[1], 0.0);
    EXPECT_EQ(corners_of(other), "0.2,1.12:-1.6,-0.76:1.5,-0.52");
}

TEST(LessonEvents, WhatIsStillSeenOfAnotherLessonHasNoCorners) {
    const WindowState seen = showing("edge-table");
    const demo::Screen screen = screen_of(seen.lesson);
    WindowState state = showing("mach-bands");
    state.lesson.corner = 1;
    state.lesson.drag = MovingCorner{1, {}};
    const auto settings = state.lesson.settings;
    for (const Event& event : std::vector<Event>{Move{{30.0, 30.0}}, Nudge{1, 0}, Key{'\t'}})
        state = after_in_lesson(std::move(state), event, {screen, {{0, 0, 100, 80}}, {100, 80}});
    EXPECT_EQ(state.lesson.settings, settings);
}

TEST(LessonState, ItsCommandHasNoStepThatItsPolygonHasNot) {
    WindowState state = showing("edge-table");
    demo::set(state.lesson.settings, state.lesson.lesson(), "corners=0,0:0,0.2:0.2,0");
    const demo::Screen screen = screen_of(state.lesson);
    const LessonState shown = as_shown(state.lesson, screen);
    EXPECT_EQ(shown.settings.at("step"), last_value(shown.lesson().controls.front(), screen));
    EXPECT_LT(shown.settings.at("step"), 60.0);
}

TEST(LessonEvents, ArrowsStepAndStepBack) {
    WindowState state = showing("edge-table");
    const double start = step_of(state);
    state = after_all(std::move(state), {NamedKey::right, NamedKey::right});
    EXPECT_EQ(step_of(state), start + 2);
    state = after_all(std::move(state), {NamedKey::left});
    EXPECT_EQ(step_of(state), start + 1);
    EXPECT_GT(step_of(after_all(state, {NamedKey::down})), start + 2);
    EXPECT_EQ(step_of(after_all(state, {NamedKey::home})), 0.0);
    EXPECT_LT(step_of(after_all(state, {NamedKey::up})), start + 1);
}

TEST(LessonEvents, KeysLeadThroughTheCourseAndOutOfIt) {
    WindowState state = after_all(showing("edge-table"), {NamedKey::page_down});
    EXPECT_EQ(state.lesson.lesson().name, "mach-bands");
    state = after_all(std::move(state), {Key{'a'}});
    EXPECT_EQ(state.lesson.answer, Answer::shown);
    state = after_all(std::move(state), {NamedKey::page_up, NamedKey::escape});
    EXPECT_EQ(state.subject, Subject::scene);
    state = after(std::move(state), Key{'c'}, {});
    EXPECT_EQ(state.subject, Subject::lesson);
    EXPECT_EQ(state.lesson.lesson().name, "edge-table");
}

// ---- the layout

bool overlap(const Box& a, const Box& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

TEST(LessonLayout, NothingOverlapsNorLeavesTheCanvas) {
    for (const raster::Viewport canvas : {raster::Viewport{960, 720}, {1280, 720}, {640, 480}}) {
        for (std::size_t place = 0; place < demo::lessons().size(); ++place) {
            const auto shape = shape_of(screen_of(opened(place, english)));
            const LessonLayout layout = layout_of(shape, canvas);
            std::vector<Box> all = layout.panels;
            all.insert(all.end(), layout.plots.begin(), layout.plots.end());
            if (shape.tables > 0) all.push_back(layout.tables);
            for (std::size_t i = 0; i < all.size(); ++i) {
                EXPECT_GE(all[i].width, 120) << place << " " << canvas.width;
                EXPECT_LE(all[i].x + all[i].width, canvas.width);
                EXPECT_LE(all[i].y + all[i].height, canvas.height) << place;
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_FALSE(overlap(all[i], all[k])) << place;
            }
        }
    }
}

}  // namespace
}  // namespace scanlight::apps::window
