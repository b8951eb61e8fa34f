#include "render/steps.h"

#include <gtest/gtest.h>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{40, 30};

using Cover = raster::Plane<char>;

Cover covered_by(const std::vector<PolygonSteps>& polygons) {
    Cover cover(size, 0);
    for (const auto& polygon : polygons) {
        for (const auto& line : polygon.trace.scanlines) {
            for (const auto& span : line.spans) {
                for (int x = span.x_begin; x < span.x_end; ++x)
                    cover.at(x, line.y) = 1;
            }
        }
    }
    return cover;
}

Cover covered_by(const raster::Plane<raster::Depth>& depth) {
    Cover cover(size, 0);
    for_each_pixel(size, [&](int x, int y) {
        cover.at(x, y) = depth.at(x, y) == raster::depth_clear ? 0 : 1;
    });
    return cover;
}

TEST(Steps, SpansCoverThePixelsThatAreDrawn) {
    Random random(1);
    for (const auto* shape : {"star:5", "torus:8,5", "cube", "icosphere:1"}) {
        const auto mesh = shape_mesh(shape);
        for (int i = 0; i < 12; ++i) {
            Scene scene = scene_of(mesh, {{random.between(0.0, 360.0), 20.0}, size});
            scene.camera.magnification *= i % 4 == 3 ? 3.0 : 1.0;  // clipped
            Settings settings;
            settings.shading = all_shadings[static_cast<std::size_t>(i % 3)];
            settings.cull = i % 2 ? Cull::back : Cull::none;
            EXPECT_EQ(covered_by(trace_polygons(scene, settings, size)),
                      covered_by(draw(scene, settings, size).framebuffer.depth))
                << shape << ' ' << i;
        }
    }
}

TEST(Steps, NameWhatTheShadingInterpolates) {
    const auto mesh = shape_mesh("ngon:5");
    const Scene scene = scene_of(mesh, {{}, size});
    const auto names = [&](Shading shading, Perspective perspective = Perspective::affine) {
        Settings settings;
        settings.shading = shading;
        settings.perspective = perspective;
        return trace_polygons(scene, settings, size).at(0).names;
    };
    EXPECT_EQ(names(Shading::flat), std::vector<std::string>{});
    EXPECT_EQ(names(Shading::gouraud), (std::vector<std::string>{"I_r", "I_g", "I_b"}));
    EXPECT_EQ(names(Shading::phong), (std::vector<std::string>{"N_x", "N_y", "N_z"}));
    EXPECT_EQ(names(Shading::gouraud, Perspective::correct),
              (std::vector<std::string>{"I_r q", "I_g q", "I_b q"}));
}

TEST(Steps, EachNumberBelongsToAName) {
    const auto mesh = shape_mesh("star:5");
    Settings settings;
    settings.shading = Shading::gouraud;
    for (const auto& polygon : trace_polygons(scene_of(mesh, {{}, size}), settings, size)) {
        for (const auto& corner : polygon.corners)
            EXPECT_EQ(corner.values.size(), polygon.names.size());
        for (const auto& edge : polygon.trace.edge_table) {
            EXPECT_EQ(edge.values.size(), polygon.names.size());
            EXPECT_EQ(edge.steps.size(), polygon.names.size());
            EXPECT_LT(edge.index, polygon.corners.size());
        }
    }
}

TEST(Steps, ShowIntensitiesAsTheyAreHoweverBright) {
    const auto mesh = shape_mesh("star:5");
    Settings settings;
    settings.shading = Shading::gouraud;
    Scene scene = scene_of(mesh, {{}, size});
    const PolygonSteps dim = trace_polygons(scene, settings, size).at(0);
    scene.lighting.ambient *= 64.0f;
    scene.lighting.lights.at(0).intensity *= 64.0f;
    const PolygonSteps bright = trace_polygons(scene, settings, size).at(0);
    const auto expect_64_fold = [](const auto& a, const auto& b) {
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(b.values[k] / a.values[k], 64.0, 1e-5);
    };
    expect_64_fold(dim.corners.at(0), bright.corners.at(0));
    expect_64_fold(dim.trace.edge_table.at(0), bright.trace.edge_table.at(0));
    const auto& dim_line = dim.trace.scanlines.at(size.height / 2);
    const auto& bright_line = bright.trace.scanlines.at(size.height / 2);
    expect_64_fold(dim_line.active.at(0), bright_line.active.at(0));
    expect_64_fold(dim_line.spans.at(0), bright_line.spans.at(0));
}

TEST(Steps, SeeOnlyPolygonsThatAreSeen) {
    const auto mesh = shape_mesh("cube");
    const Scene scene = scene_of(mesh, {{30.0, 40.0}, size});
    Settings settings;
    EXPECT_EQ(trace_polygons(scene, settings, size).size(), 6u);
    settings.cull = Cull::back;
    const auto seen = trace_polygons(scene, settings, size);
    ASSERT_EQ(seen.size(), 3u);
    const auto ids = draw_ids(scene, settings, size);
    for (const auto& polygon : seen) {
        EXPECT_EQ(polygon.id, polygon.face + 1);
        EXPECT_NE(std::count(ids.values().begin(), ids.values().end(), polygon.id), 0);
    }
}

TEST(Steps, OfChosenPolygonsAreThoseOfAll) {
    const auto mesh = shape_mesh("cube");
    const Scene scene = scene_of(mesh, {{30.0, 40.0}, size});
    Settings settings;
    settings.cull = Cull::back;
    const auto all = trace_polygons(scene, settings, size);
    const auto seen = seen_polygons(scene, settings, size);
    ASSERT_EQ(seen.size(), all.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const auto alone = trace_polygons(scene, settings, size, {seen[i]});
        ASSERT_EQ(alone.size(), 1u);
        EXPECT_EQ(alone[0].face, all[i].face);
        EXPECT_EQ(alone[0].id, all[i].id);
        EXPECT_EQ(covered_by(alone), covered_by(std::vector{all[i]}));
        EXPECT_EQ(static_cast<std::size_t>(seen[i].scanlines), all[i].trace.scanlines.size());
    }
}

TEST(Steps, OfNothingAreNone) {
    EXPECT_TRUE(trace_polygons({}, {}, size).empty());
}

}  // namespace
}  // namespace scanlight::render
