#include "apps/demo/window/state.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "apps/demo/window/camera_moves.h"
#include "apps/demo/window/events.h"
#include "apps/demo/window/light_handles.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/models.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps::window {
namespace {

struct Stage {
    explicit Stage(const std::string& command_line = "sphere:12,6 --size 400x300")
        : state(window_of(parse_scene(command_line))) {
        look();
    }

    void look() {
        const Models models = load_models(state.views[0]);
        for (std::size_t i = 0; i < 2; ++i)
            cameras[i] = scene_of(models, state.views[i]).camera;
    }
    void happens(const Event& event) { state = after(std::move(state), event, cameras); }
    void drag(Point from, Point to, Button button = Button::left) {
        happens(Press{from, button});
        happens(Move{to});
        happens(Release{});
    }

    WindowState state;
    Cameras cameras;
};

double distance_of(const SceneOptions& options) {
    return glm::length(*options.eye - options.target.value_or(glm::dvec3(0.0)));
}

// ---- panes

TEST(WindowState, OneViewHasTheWholeCanvas) {
    const Stage stage;
    const auto panes = panes_of(stage.state);
    ASSERT_EQ(panes.size(), 1u);
    EXPECT_EQ(panes[0].visible, (Box{0, 0, 400, 300}));
}

TEST(WindowState, PanesOfTwoViewsShareAllColumnsOfTheCanvas) {
    for (const Arrangement arrangement : {Arrangement::wipe, Arrangement::beside}) {
        for (const double divider : {0.0, 0.3, 0.5, 1.0}) {
            WindowState state = Stage().state;
            state.divider = divider;
            state = arranged(std::move(state), arrangement);
            const auto panes = panes_of(state);
            ASSERT_EQ(panes.size(), 2u);
            EXPECT_EQ(panes[0].visible.x, 0);
            EXPECT_EQ(panes[0].visible.width, panes[1].visible.x);
            EXPECT_EQ(panes[1].visible.x + panes[1].visible.width, 400);
        }
    }
}

TEST(WindowState, AViewsPictureIsAsLargeAsItsPane) {
    for (const Arrangement arrangement :
         {Arrangement::one, Arrangement::wipe, Arrangement::beside, Arrangement::difference}) {
        const WindowState state = arranged(Stage().state, arrangement);
        for (const Pane& pane : panes_of(state)) {
            EXPECT_EQ(state.of(pane.view).size.width, pane.picture.width);
            EXPECT_EQ(state.of(pane.view).size.height, pane.picture.height);
        }
    }
}

TEST(WindowState, TheDividerGoesWhereItIsDragged) {
    Stage stage;
    stage.state = arranged(std::move(stage.state), Arrangement::beside);
    stage.look();
    stage.drag({200, 20}, {120, 40});
    EXPECT_EQ(divider_column(stage.state), 120);
    EXPECT_EQ(stage.state.of(View::left).size.width, 120);
    EXPECT_EQ(stage.state.of(View::right).size.width, 280);
}

// ---- cameras

TEST(WindowCamera, ADragTurnsAndKeepsTheDistance) {
    Stage stage;
    const double before = glm::length(stage.cameras[0].eye - stage.cameras[0].target);
    stage.drag({50, 50}, {90, 60});
    ASSERT_TRUE(stage.state.views[0].eye);
    EXPECT_NEAR(distance_of(stage.state.views[0]), before, 1e-3 * before);
    const auto angles = angles_of(*stage.state.views[0].eye - *stage.state.views[0].target);
    EXPECT_NEAR(angles.azimuth_deg, 30.0 - 16.0, 0.1);
    EXPECT_NEAR(angles.elevation_deg, 20.0 + 4.0, 0.1);
}

TEST(WindowCamera, ADragThereAndBackChangesNothing) {
    Stage stage;
    stage.drag({50, 50}, {51, 50});
    const SceneOptions before = stage.state.views[0];
    stage.look();
    stage.happens(Press{{50, 50}});
    for (const double x : {80.0, 300.0, 2.0, 50.0})
        stage.happens(Move{{x, 50 + (x - 50) / 2}});
    EXPECT_NEAR(glm::length(*stage.state.views[0].eye - *before.eye), 0.0, 1e-3);
}

TEST(WindowCamera, NeverTurnsOverThePoles) {
    Stage stage;
    stage.drag({50, 50}, {50, 5000});
    const auto angles = angles_of(*stage.state.views[0].eye - *stage.state.views[0].target);
    EXPECT_NEAR(angles.elevation_deg, 89.0, 0.1);
}

TEST(WindowCamera, BothViewsMoveAlike) {
    Stage stage;
    stage.drag({50, 50}, {90, 60});
    stage.happens(Wheel{2.0});
    EXPECT_EQ(*stage.state.views[0].eye, *stage.state.views[1].eye);
    EXPECT_EQ(stage.state.views[0].zoom, stage.state.views[1].zoom);
}

/// Of a point of the world, in pixels.
Point seen_at(const glm::dvec3& point, const render::Camera& camera) {
    const glm::dvec4 clip = render::clip_from_eye(camera, 400.0 / 300.0) *
                            render::eye_from_world(camera) * glm::dvec4(point, 1.0);
    return {(clip.x / clip.w + 1.0) * 200.0, (1.0 - clip.y / clip.w) * 150.0};
}

TEST(WindowCamera, WhatIsPannedStaysUnderTheMouse) {
    for (const std::string projection : {"perspective", "orthographic"}) {
        Stage stage("sphere:12,6 --size 400x300 --zoom 1.7 --projection " + projection);
        const glm::dvec3 target = stage.cameras[0].target;
        const Point before = seen_at(target, stage.cameras[0]);
        stage.drag({100, 100}, {137, 78}, Button::right);
        stage.look();
        const Point now = seen_at(target, stage.cameras[0]);
        EXPECT_NEAR(now.x - before.x, 37.0, 0.1) << projection;
        EXPECT_NEAR(now.y - before.y, -22.0, 0.1) << projection;
    }
}

TEST(WindowCamera, TheWheelZoomsThereAndBack) {
    Stage stage;
    stage.happens(Wheel{3.0});
    EXPECT_NEAR(stage.state.views[0].zoom, 1.331, 1e-3);
    stage.happens(Wheel{-3.0});
    EXPECT_NEAR(stage.state.views[0].zoom, 1.0, 1e-3);
}

TEST(WindowCamera, FramingForgetsWhereTheCameraWas) {
    Stage stage;
    stage.drag({50, 50}, {90, 60});
    stage.happens(Wheel{3.0});
    stage.happens(Key{'f'});
    EXPECT_FALSE(stage.state.views[0].eye);
    EXPECT_EQ(stage.state.views[0].zoom, 1.0);
}

// ---- lights

constexpr Box picture{0, 0, 400, 300};

TEST(WindowLights, ALightComesFromWhereItsHandleIsPut) {
    const Stage stage;
    for (const Point at : {Point{200, 150}, Point{240, 150}, Point{150, 40}, Point{190, 280}}) {
        for (const LightFrame frame : {LightFrame::camera, LightFrame::world}) {
            SceneOptions options = stage.state.views[0];
            options.lights = {{frame, glm::dvec3(1.0, 0.0, 0.0)}};
            options = with_light_at(options, 0, at, stage.cameras[0], picture);
            const auto handles = light_handles(options, stage.cameras[0], picture);
            ASSERT_EQ(handles.size(), 1u);
            EXPECT_NEAR(handles[0].at.x, at.x, 0.5);
            EXPECT_NEAR(handles[0].at.y, at.y, 0.5);
        }
    }
}

TEST(WindowLights, TheMiddleIsTheViewersAndTheOuterCircleIsBehind) {
    const Stage stage;
    const double circle = light_circle(picture);
    const auto direction_at = [&](double x) {
        const auto options =
            with_light_at(stage.state.views[0], 0, {200 + x, 150}, stage.cameras[0], picture);
        return options.lights.at(0).place;
    };
    EXPECT_NEAR(direction_at(0.0).z, 1.0, 1e-3);
    EXPECT_NEAR(direction_at(circle).x, 1.0, 1e-3);
    EXPECT_NEAR(direction_at(2.0 * circle).z, -1.0, 1e-3);
}

TEST(WindowLights, ALampFollowsTheMouseAtItsDepth) {
    const Stage stage;
    SceneOptions options = stage.state.views[0];
    options.lights = {{LightFrame::point, glm::dvec3(0.5, 1.0, 0.2)}};
    options = with_light_at(options, 0, {111, 222}, stage.cameras[0], picture);
    const auto handles = light_handles(options, stage.cameras[0], picture);
    ASSERT_EQ(handles.size(), 1u);
    EXPECT_NEAR(handles[0].at.x, 111.0, 0.5);
    EXPECT_NEAR(handles[0].at.y, 222.0, 0.5);
}

TEST(WindowLights, ALampBehindTheEyeHasNoHandle) {
    const Stage stage;
    SceneOptions options = stage.state.views[0];
    const auto& camera = stage.cameras[0];
    options.lights = {{LightFrame::point, camera.eye + (camera.eye - camera.target)}};
    EXPECT_TRUE(light_handles(options, camera, picture).empty());
}

TEST(WindowLights, AHandleIsTakenBeforeTheCamera) {
    Stage stage;
    const auto handle = light_handles(stage.state.views[0], stage.cameras[0], picture).at(0).at;
    EXPECT_EQ(target_at(stage.state, handle, stage.cameras), Target::light);
    stage.drag(handle, {200, 150});
    EXPECT_FALSE(stage.state.views[0].eye);
    ASSERT_EQ(stage.state.views[0].lights.size(), 1u);
    EXPECT_NEAR(stage.state.views[0].lights[0].place.z, 1.0, 1e-2);
    EXPECT_TRUE(stage.state.views[1].lights.empty()) << "each view has lights of its own";
}

TEST(WindowLights, OneStays) {
    SceneOptions options = with_more_light({}, {LightFrame::point, glm::dvec3(1.0)});
    EXPECT_EQ(options.lights.size(), 2u);
    options = with_less_light(with_less_light(with_less_light(options)));
    EXPECT_EQ(options.lights.size(), 1u);
}

// ---- inputs and keys

TEST(WindowState, AnotherMeshIsSeenByTheSettingsThereAre) {
    Stage stage("teapot --shading flat --eye 1,2,3");
    stage.state = with_input(std::move(stage.state), "cube");
    for (const SceneOptions& view : stage.state.views) {
        ASSERT_EQ(view.objects.size(), 1u);
        EXPECT_EQ(view.objects[0].input, "cube");
        EXPECT_EQ(view.settings.shading, render::Shading::flat);
        EXPECT_FALSE(view.eye) << "the camera of another thing";
    }
}

TEST(WindowState, KeysArrangeTheViews) {
    Stage stage;
    stage.happens(Key{'3'});
    EXPECT_EQ(stage.state.arrangement, Arrangement::beside);
    stage.happens(Key{'\t'});
    EXPECT_EQ(stage.state.chosen, View::right);
    stage.happens(Key{'l'});
    EXPECT_EQ(stage.state.loupe, Loupe::open);
    stage.happens(Move{{10, 20}});
    stage.happens(Key{'p'});
    EXPECT_EQ(stage.state.picked, (Point{10, 20}));
}

TEST(WindowState, APressChoosesItsView) {
    Stage stage;
    stage.happens(Key{'2'});
    stage.drag({300, 50}, {300, 50});
    EXPECT_EQ(stage.state.chosen, View::right);
}

}  // namespace
}  // namespace scanlight::apps::window
