// What hides what, what is left out, and which side of it is lit.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/renderer.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{64, 48};

Settings shaded(Shading shading) {
    Settings settings;
    settings.shading = shading;
    return settings;
}

Settings with_cull(Settings settings, Cull cull) {
    settings.cull = cull;
    return settings;
}

/// Shifted a little off the origin and turned, so that nothing lies symmetrically.
Object shifted(const mesh::Mesh& mesh, const glm::dvec3& shift) {
    Object object = object_of(mesh);
    object.world_from_object[3] = glm::dvec4(shift, 1.0);
    return object;
}

// ---- culling

TEST(Visibility, CulledBackFacesOfAClosedBodyAreNotMissed) {
    Random random(1);
    for (const auto shape : closed_shapes) {
        const auto mesh = shape_mesh(shape);
        for (int i = 0; i < 6; ++i) {
            const double azimuth = random.between(-180.0, 180.0);
            const View view{{azimuth, random.between(-80.0, 80.0)},
                            size,
                            all_projections[static_cast<std::size_t>(i % 2)]};
            const Scene scene = scene_of(mesh, view);
            const Settings all = shaded(all_shadings[static_cast<std::size_t>(i % 3)]);
            const auto none = draw(scene, all, size);
            const auto back = draw(scene, with_cull(all, Cull::back), size);
            EXPECT_EQ(none.framebuffer.color, back.framebuffer.color) << shape << ' ' << i;
            EXPECT_EQ(none.framebuffer.depth, back.framebuffer.depth) << shape << ' ' << i;
            EXPECT_GT(back.counts.culled, 0u);
        }
    }
}

TEST(Visibility, FrontAndBackFacesPartThePolygons) {
    const auto mesh = shape_mesh("teapot:3");
    const Scene scene = scene_of(mesh, {{}, size});
    const auto all = draw(scene, {}, size).counts;
    const auto back = draw(scene, with_cull({}, Cull::back), size).counts;
    const auto front = draw(scene, with_cull({}, Cull::front), size).counts;
    EXPECT_EQ(back.drawn + front.drawn, all.drawn);
    EXPECT_EQ(back.culled, front.drawn);
    EXPECT_EQ(front.culled, back.drawn);
}

TEST(Visibility, CulledFrontFacesShowTheInside) {
    const auto mesh = shape_mesh("cube");
    const Scene scene = scene_of(mesh, {{}, size});
    const auto front = draw_ids(scene, with_cull({}, Cull::back), size);
    const auto inside = draw_ids(scene, with_cull({}, Cull::front), size);
    for_each_pixel(size, [&](int x, int y) {
        EXPECT_EQ(front.at(x, y) == 0, inside.at(x, y) == 0);
        if (front.at(x, y) != 0) {
            EXPECT_NE(front.at(x, y), inside.at(x, y));
        }
    });
}

// ---- sides

/// The same surface turned inside out. The first corner stays first.
mesh::Mesh turned(mesh::Mesh mesh) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::reverse(mesh.corners.begin() + mesh.face_begin[f] + 1,
                     mesh.corners.begin() + mesh.face_begin[f + 1]);
        mesh.face_normals[f] = -mesh.face_normals[f];
    }
    for (auto* stream : {&mesh.vertices.nx, &mesh.vertices.ny, &mesh.vertices.nz}) {
        for (float& component : *stream)
            component = -component;
    }
    return mesh;
}

TEST(Visibility, TwoSidedSurfacesLookTheSameTurnedInsideOut) {
    for (const auto* shape : {"plane:3", "star:5", "teapot:3", "sphere:12,6"}) {
        const auto mesh = shape_mesh(shape);
        const auto inside_out = turned(mesh);
        for (const ViewAngles angles : {ViewAngles{30.0, 25.0}, ViewAngles{150.0, -40.0}}) {
            for (const Shading shading : all_shadings) {
                const auto a = draw(scene_of(mesh, {angles, size}), shaded(shading), size);
                const auto b = draw(scene_of(inside_out, {angles, size}), shaded(shading), size);
                EXPECT_LE(largest_difference(a.framebuffer.color, b.framebuffer.color), 1e-6f)
                    << shape;
                EXPECT_EQ(a.framebuffer.depth, b.framebuffer.depth) << shape;
            }
        }
    }
}

TEST(Visibility, OneSidedSurfacesAreDarkFromBehind) {
    const auto mesh = shape_mesh("plane:3");
    Scene scene = scene_of(mesh, {{30.0, -40.0}, size});
    scene.lighting.lights = {white_light({0.0f, -1.0f, 0.0f})};  // from below, as the eye
    const glm::vec3 ambient = scene.lighting.ambient * plastic().ambient;
    for (const Shading shading : all_shadings) {
        Settings one = shaded(shading);
        one.sides = Sides::one;
        const auto dark = draw(scene, one, size).framebuffer.color;
        const auto lit = draw(scene, shaded(shading), size).framebuffer.color;
        const auto& d = dark.at(size.width / 2, size.height / 2);
        const auto& l = lit.at(size.width / 2, size.height / 2);
        EXPECT_NEAR(d.r, ambient.r, 1e-6);
        EXPECT_GT(l.r, ambient.r + 0.3f);
    }
}

// ---- placing

/// The mirror image in x, built as a mesh of its own.
mesh::Mesh mirrored(mesh::Mesh mesh) {
    for (auto* stream : {&mesh.vertices.x, &mesh.vertices.nx}) {
        for (float& component : *stream)
            component = -component;
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::reverse(mesh.corners.begin() + mesh.face_begin[f] + 1,
                     mesh.corners.begin() + mesh.face_begin[f + 1]);
        mesh.face_normals[f].x = -mesh.face_normals[f].x;
    }
    return mesh;
}

TEST(Visibility, AMirroredPlacementIsTheMirroredMesh) {
    const auto teapot = shape_mesh("teapot:3");
    const auto mirror_image = mirrored(teapot);
    Object placed_mirrored = object_of(teapot);
    placed_mirrored.world_from_object[0][0] = -1.0;
    const Scene expected = scene_of(mirror_image, {{}, size});
    Scene scene = expected;
    scene.objects = {placed_mirrored};
    for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
        for (const Shading shading : all_shadings) {
            const Settings settings = with_cull(shaded(shading), cull);
            const auto a = draw(expected, settings, size);
            const auto b = draw(scene, settings, size);
            EXPECT_LE(largest_difference(a.framebuffer.color, b.framebuffer.color), 1e-6f);
            EXPECT_EQ(a.framebuffer.depth, b.framebuffer.depth);
            EXPECT_EQ(a.counts.culled, b.counts.culled);
        }
    }
}

TEST(Visibility, NormalsTurnByTheInverseTranspose) {
    const auto mesh = shape_mesh("icosphere:3");
    Object flattened = object_of(mesh);
    flattened.world_from_object[1][1] = 0.1;  // a disc: its normals turn up, not with its points
    const Scene scene = scene_of(std::vector{flattened}, {{0.0, 45.0}, size});
    const auto normals = draw_normals(scene, {}, size);
    std::size_t upward = 0;
    std::size_t shown = 0;
    for (const glm::vec3& n : normals.values()) {
        shown += n != glm::vec3(0.0f) ? 1 : 0;
        upward += n.y > 0.9f ? 1 : 0;
    }
    EXPECT_GT(shown, 500u);
    EXPECT_GT(upward, shown * 3 / 4);
}

// ---- order

TEST(Visibility, TheOrderOfObjectsMattersOnlyForTies) {
    const auto sphere = shape_mesh("sphere:12,6");
    const auto cube = shape_mesh("cube");
    Random random(5);
    for (int i = 0; i < 20; ++i) {
        Object a = shifted(sphere, random.in_cube(0.8));
        Object b = shifted(cube, random.in_cube(0.8));
        b.materials[0].diffuse = glm::vec3(0.1f, 0.6f, 0.2f);
        const Scene there = scene_of(std::vector{a, b}, {{}, size});
        Scene back = there;
        std::swap(back.objects[0], back.objects[1]);
        Scene alone = there;
        alone.objects = {a};
        const auto depth_a = draw(alone, {}, size).framebuffer.depth;
        alone.objects = {b};
        const auto depth_b = draw(alone, {}, size).framebuffer.depth;

        const auto first = draw(there, {}, size).framebuffer;
        const auto second = draw(back, {}, size).framebuffer;
        EXPECT_EQ(first.depth, second.depth);
        for_each_pixel(size, [&](int x, int y) {
            const bool tie = depth_a.at(x, y) == depth_b.at(x, y);
            if (!tie) {
                ASSERT_EQ(first.color.at(x, y), second.color.at(x, y));
            }
        });
    }
}

TEST(Visibility, OfTwoEqualObjectsTheFirstIsSeen) {
    const auto mesh = shape_mesh("torus:10,6");
    Object red = object_of(mesh);
    Object green = object_of(mesh);
    green.materials[0].diffuse = glm::vec3(0.1f, 0.9f, 0.1f);
    const Scene alone = scene_of(std::vector{red}, {{}, size});
    Scene both = alone;
    both.objects = {red, green};
    EXPECT_EQ(draw(both, {}, size).framebuffer.color, draw(alone, {}, size).framebuffer.color);
    both.objects = {green, red};
    EXPECT_NE(draw(both, {}, size).framebuffer.color, draw(alone, {}, size).framebuffer.color);
}

// ---- nothing, and little

TEST(Visibility, NothingIsDrawnOfNothing) {
    const mesh::Mesh empty = mesh::build(mesh::PolygonSoup{}).mesh;
    Scene scene = scene_of(empty, {{}, size});
    scene.background = raster::Rgba(0.1f, 0.2f, 0.3f, 1.0f);
    for (const auto& objects : {scene.objects, std::vector<Object>{}}) {
        scene.objects = objects;
        for (const Shading shading : all_shadings) {
            const Drawing drawing = draw(scene, shaded(shading), size);
            EXPECT_EQ(drawing.counts.polygons, 0u);
            EXPECT_EQ(covered_pixels(drawing.framebuffer.depth), 0u);
            for (const auto& color : drawing.framebuffer.color.values())
                ASSERT_EQ(color, scene.background);
        }
    }
}

TEST(Visibility, EveryPixelThatPassesIsLit) {
    const auto mesh = shape_mesh("teapot:3");
    for (const Shading shading : all_shadings) {
        const Drawing drawing = draw(scene_of(mesh, {{}, size}), shaded(shading), size);
        EXPECT_GE(drawing.counts.pixels_passed, covered_pixels(drawing.framebuffer.depth));
        EXPECT_EQ(drawing.counts.pixels_shaded, drawing.counts.pixels_passed);
    }
}

TEST(Visibility, WhatIsBehindTheCameraIsOutside) {
    const auto mesh = shape_mesh("teapot:3");
    Scene scene = scene_of(mesh, {{}, size});
    scene.camera.target = 2.0 * scene.camera.eye - scene.camera.target;  // looks away
    const Drawing drawing = draw(scene, {}, size);
    EXPECT_EQ(drawing.counts.outside, mesh.face_count());
    EXPECT_EQ(covered_pixels(drawing.framebuffer.depth), 0u);
}

TEST(Visibility, FromInsideAClosedBodyNoPixelIsEmpty) {
    Random random(6);
    for (const auto* shape : {"cube", "sphere:12,6", "icosphere:3", "cylinder:9"}) {
        const auto mesh = shape_mesh(shape);
        for (int i = 0; i < 20; ++i) {
            Scene scene = scene_of(mesh, {{}, size});
            scene.camera.eye = random.in_cube(0.4);
            scene.camera.target = scene.camera.eye + random.direction();
            scene.camera.magnification = magnification_from_fov(random.between(20.0, 150.0));
            scene.camera = with_fitted_planes(scene.camera, scene.objects);
            const Drawing drawing = draw(scene, {}, size);
            EXPECT_EQ(covered_pixels(drawing.framebuffer.depth),
                      static_cast<std::size_t>(size.width * size.height))
                << shape << ' ' << i;
            for (const auto& color : drawing.framebuffer.color.values()) {
                ASSERT_TRUE(color.r >= 0.0f && color.r < 4.0f) << "NaN, or no colour at all";
            }
        }
    }
}

TEST(Visibility, TheSmallestPicturesAreDrawn) {
    const auto mesh = shape_mesh("sphere:12,6");
    for (const raster::Viewport tiny :
         {raster::Viewport{1, 1}, raster::Viewport{3, 1}, raster::Viewport{1, 3}}) {
        for (const Shading shading : all_shadings) {
            const Scene scene = scene_of(mesh, {{}, tiny});
            const Drawing drawing = draw(scene, shaded(shading), tiny);
            EXPECT_NE(drawing.framebuffer.depth.at(tiny.width / 2, tiny.height / 2),
                      raster::depth_clear);
            EXPECT_EQ(drawing.framebuffer.color.at(tiny.width / 2, tiny.height / 2).a, 1.0f);
        }
    }
}

// ---- counts

TEST(DrawCounts, AddUp) {
    Random random(7);
    for (const auto* shape : {"teapot:3", "torus:10,6", "star:7"}) {
        const auto mesh = shape_mesh(shape);
        for (int i = 0; i < 9; ++i) {
            Scene scene = scene_of(mesh, {{random.between(0.0, 360.0), 30.0}, size});
            scene.camera.magnification *= random.between(0.5, 6.0);  // some lie outside
            const Settings settings =
                with_cull(shaded(all_shadings[static_cast<std::size_t>(i % 3)]),
                          i % 2 ? Cull::back : Cull::none);
            const Drawing drawing = draw(scene, settings, size);
            const DrawCounts& counts = drawing.counts;
            EXPECT_EQ(counts.polygons, mesh.face_count());
            EXPECT_EQ(counts.polygons, counts.outside + counts.culled + counts.drawn);
            EXPECT_GE(counts.pixels_passed, covered_pixels(drawing.framebuffer.depth));
            EXPECT_GE(counts.pixels_tested, counts.pixels_passed);
            EXPECT_GE(counts.pixels_tested, counts.spans);
        }
    }
}

TEST(DrawCounts, OfOneSquareAreItsPixels) {
    const auto mesh = shape_mesh("plane:1");
    Scene scene = scene_of(mesh, {{0.0, 90.0}, {32, 32}, Projection::orthographic});
    scene.camera.magnification = 1.0;  // the square from -1 to 1 fills the picture
    const auto counts = draw(scene, {}, {32, 32}).counts;
    EXPECT_EQ(counts.drawn, 1u);
    EXPECT_EQ(counts.spans, 32u);
    EXPECT_EQ(counts.pixels_tested, 1024u);
    EXPECT_EQ(counts.pixels_passed, 1024u);
}

enum class Order { front_to_back, back_to_front };

// Eight squares that fill the picture, one behind the other.
Drawing draw_layers(const mesh::Mesh& square, Order order, Renderer& renderer, DrawCounts& fast) {
    const raster::Viewport viewport{64, 96};
    Scene scene = scene_of(square, {{0.0, 90.0}, viewport, Projection::orthographic});
    scene.camera.magnification = 1.2;
    scene.camera.far += 1.0;
    scene.objects.assign(8, scene.objects.front());
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        scene.objects[i].world_from_object[3][1] =
            -0.05 * static_cast<double>(order == Order::front_to_back ? i : 7 - i);
    raster::Plane<raster::Rgba> color(viewport, scene.background);
    fast = renderer.draw(scene, {}, color).counts;
    Drawing walk = draw(scene, {}, viewport);
    EXPECT_EQ(walk.framebuffer.color, color);
    return walk;
}

TEST(DrawCounts, OfTheFastPathLeaveOutWhatIsHiddenWhole) {
    for (const auto& square : {shape_mesh("plane:1"), mesh::triangulated(shape_mesh("plane:1"))}) {
        Renderer renderer;
        DrawCounts fast;
        const DrawCounts walk = draw_layers(square, Order::front_to_back, renderer, fast).counts;
        EXPECT_LT(fast.pixels_tested, walk.pixels_tested / 2);
        EXPECT_EQ(fast.pixels_passed, walk.pixels_passed);
        const DrawCounts backwards =
            draw_layers(square, Order::back_to_front, renderer, fast).counts;
        EXPECT_EQ(fast.pixels_tested, backwards.pixels_tested);
    }
}

TEST(DrawCounts, AreSummedOverTheObjects) {
    const auto cube = shape_mesh("cube");
    const auto torus = shape_mesh("torus:10,6");
    const Scene scene = scene_of(std::vector{object_of(cube), object_of(torus)}, {{}, size});
    EXPECT_EQ(draw(scene, {}, size).counts.polygons, cube.face_count() + torus.face_count());
}

}  // namespace
}  // namespace scanlight::render
