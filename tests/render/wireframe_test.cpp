#include "render/wireframe.h"

#include <gtest/gtest.h>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{96, 96};
constexpr raster::Rgba ink{1.0f, 0.0f, 1.0f, 1.0f};

raster::Framebuffer blank() {
    return {size, raster::Rgba(0.0f)};
}

bool is_inked(const raster::Framebuffer& target, const glm::dvec3& screen) {
    const int column = static_cast<int>(screen.x);
    const int row = static_cast<int>(screen.y);
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (target.color.at(x, y) == ink) return true;
        }
    }
    return false;
}

std::size_t inked_pixels(const raster::Framebuffer& target) {
    return static_cast<std::size_t>(
        std::count(target.color.values().begin(), target.color.values().end(), ink));
}

/// The middle of each of the cube's twelve edges, and whether it is hidden from (+x, +y, +z): those
/// that meet in the corner (-1, -1, -1).
struct EdgeMiddle {
    glm::dvec3 place;
    glm::dvec3 half;  // from there to an end
    bool hidden;
};

std::vector<EdgeMiddle> cube_edges() {
    std::vector<EdgeMiddle> edges;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double a : {-1.0, 1.0}) {
            for (const double b : {-1.0, 1.0}) {
                glm::dvec3 place(0.0);
                place[(axis + 1) % 3] = a;
                place[(axis + 2) % 3] = b;
                glm::dvec3 half(0.0);
                half[axis] = 1.0;
                edges.push_back({place, half, a < 0.0 && b < 0.0});
            }
        }
    }
    return edges;
}

class WireframeOfACube : public testing::TestWithParam<Projection> {
protected:
    const mesh::Mesh cube = shape_mesh("cube");
    const Scene scene = scene_of(cube, {{25.0, 40.0}, size, GetParam()});
};

TEST_P(WireframeOfACube, ShowsAllTwelveEdges) {
    auto target = blank();
    draw_wireframe(scene, ink, HiddenLines::shown, target);
    for (const auto& edge : cube_edges())
        EXPECT_TRUE(is_inked(target, screen_from_world(scene.camera, size, edge.place)));
}

TEST_P(WireframeOfACube, WithoutHiddenLinesShowsNine) {
    auto target = draw(scene, {}, size).framebuffer;
    draw_wireframe(scene, ink, HiddenLines::removed, target);
    for (const auto& edge : cube_edges()) {
        EXPECT_EQ(is_inked(target, screen_from_world(scene.camera, size, edge.place)), !edge.hidden)
            << edge.place.x << ' ' << edge.place.y << ' ' << edge.place.z;
    }
}

/// A floor that reaches to the eye, say, takes the near plane along, and nearly all of depth.
TEST_P(WireframeOfACube, WithoutHiddenLinesShowsNineWhereverTheNearPlaneIs) {
    Scene close = scene;
    close.camera.near = GetParam() == Projection::perspective ? 0.001 : close.camera.near;
    close.camera.far *= 3.0;
    auto target = draw(close, {}, size).framebuffer;
    draw_wireframe(close, ink, HiddenLines::removed, target);
    for (const auto& edge : cube_edges()) {
        EXPECT_EQ(is_inked(target, screen_from_world(close.camera, size, edge.place)), !edge.hidden)
            << edge.place.x << ' ' << edge.place.y << ' ' << edge.place.z;
    }
}

/// Outlines of steep faces too: beside the line such a face comes much nearer.
TEST_P(WireframeOfACube, VisibleEdgesHaveNoGaps) {
    auto target = draw(scene, {}, size).framebuffer;
    draw_wireframe(scene, ink, HiddenLines::removed, target);
    for (const auto& edge : cube_edges()) {
        if (edge.hidden) continue;
        for (double t = -0.9; t < 0.95; t += 0.05) {
            const glm::dvec3 place = edge.place + t * edge.half;
            EXPECT_TRUE(is_inked(target, screen_from_world(scene.camera, size, place)))
                << place.x << ' ' << place.y << ' ' << place.z;
        }
    }
}

/// Without back faces a cube has nine edges, without front faces the nine of its other side.
TEST_P(WireframeOfACube, HasNoEdgesOfCulledPolygonsOnly) {
    Settings settings;
    const auto shows = [&](Cull cull, const EdgeMiddle& edge) {
        settings.cull = cull;
        auto target = blank();
        draw_wireframe(scene, ink, HiddenLines::shown, target, settings);
        return is_inked(target, screen_from_world(scene.camera, size, edge.place));
    };
    for (const auto& edge : cube_edges()) {
        const bool in_front = edge.place.x + edge.place.y + edge.place.z > 1.5;
        EXPECT_EQ(shows(Cull::back, edge), !edge.hidden);
        EXPECT_EQ(shows(Cull::front, edge), !in_front);
    }
}

TEST_P(WireframeOfACube, NeedsOnlyTheDepthOfThePolygons) {
    for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
        Settings settings;
        settings.cull = cull;
        auto unlit = draw_depth(scene, settings, size);
        auto lit = draw(scene, settings, size);
        EXPECT_EQ(unlit.framebuffer.depth, lit.framebuffer.depth);
        EXPECT_EQ(unlit.framebuffer.color, blank().color);
        EXPECT_EQ(unlit.counts.pixels_passed, lit.counts.pixels_passed);
        EXPECT_EQ(unlit.counts.culled, lit.counts.culled);
    }
}

INSTANTIATE_TEST_SUITE_P(Cameras, WireframeOfACube, testing::ValuesIn(all_projections),
                         [](const auto& param) {
                             return param.param == Projection::perspective ? "perspective"
                                                                           : "orthographic";
                         });

TEST(Wireframe, HidesNothingWhereNothingWasDrawn) {
    const auto mesh = shape_mesh("torus:10,6");
    const Scene scene = scene_of(mesh, {{30.0, 40.0}, size});
    auto all = blank();
    auto visible = blank();
    draw_wireframe(scene, ink, HiddenLines::shown, all);
    draw_wireframe(scene, ink, HiddenLines::removed, visible);
    EXPECT_EQ(all.color, visible.color);
}

TEST(Wireframe, VisibleLinesAreSomeOfAll) {
    const auto mesh = shape_mesh("torus:10,6");
    const Scene scene = scene_of(mesh, {{30.0, 40.0}, size});
    auto all = blank();
    auto visible = draw(scene, {}, size).framebuffer;
    draw_wireframe(scene, ink, HiddenLines::shown, all);
    draw_wireframe(scene, ink, HiddenLines::removed, visible);
    for_each_pixel(size, [&](int x, int y) {
        if (visible.color.at(x, y) == ink) {
            EXPECT_EQ(all.color.at(x, y), ink);
        }
    });
    EXPECT_LT(inked_pixels(visible), inked_pixels(all) * 3 / 4);
    EXPECT_GT(inked_pixels(visible), inked_pixels(all) / 4);
}

TEST(Wireframe, LeavesDepthAsItWas) {
    const auto mesh = shape_mesh("cube");
    const Scene scene = scene_of(mesh, {{}, size});
    auto target = draw(scene, {}, size).framebuffer;
    const auto depth = target.depth;
    draw_wireframe(scene, ink, HiddenLines::removed, target);
    EXPECT_EQ(target.depth, depth);
}

TEST(Wireframe, FromInsideIsClippedToThePicture) {
    const auto mesh = shape_mesh("sphere:12,6");
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        Scene scene = scene_of(mesh, {{}, size});
        scene.camera.eye = random.in_cube(0.9);
        scene.camera.target = random.in_cube(0.9);
        scene.camera = with_fitted_planes(scene.camera, scene.objects);
        auto target = blank();
        draw_wireframe(scene, ink, HiddenLines::shown, target);
        EXPECT_GT(inked_pixels(target), 0u);
    }
}

}  // namespace
}  // namespace scanlight::render
