#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/face_shadow.h"
#include "render/light_view.h"
#include "render/shadows.h"
#include "tests/render/scenes.h"

namespace scanlight::render {

using Counts = raster::Plane<std::int32_t>;

/// Closed casters over a floor, some touching or cutting it, and up to `most_lights` lights.
struct RandomScene {
    std::vector<mesh::Mesh> meshes;
    Scene scene;
};

inline RandomScene random_scene(std::uint32_t seed, int most_lights) {
    Random random(seed);
    const char* shapes[] = {"cube", "tetrahedron", "sphere:7,5", "torus:8,5", "octahedron"};
    RandomScene result;
    const int casters = 1 + random.below(4);
    for (int i = 0; i < casters; ++i)
        result.meshes.push_back(shape_mesh(shapes[random.below(5)]));
    result.meshes.push_back(shape_mesh("plane:2"));
    for (const mesh::Mesh& mesh : result.meshes) {
        Object object{&mesh, shading_materials(mesh.materials)};
        const bool is_floor = &mesh == &result.meshes.back();
        const double scale = is_floor ? 5.0 : random.between(0.2, 0.9);
        const glm::dvec3 place = is_floor ? glm::dvec3(0.0, -1.0, 0.0) : random.in_cube(1.5);
        for (int k = 0; k < 3; ++k)
            object.world_from_object[k][k] = scale;
        object.world_from_object[3] = glm::dvec4(place, 1.0);
        result.scene.objects.push_back(object);
    }
    const int lights = 1 + random.below(most_lights);
    for (int i = 0; i < lights; ++i) {
        const bool is_point = random.below(2) == 0;
        const glm::vec3 place(random.in_cube(is_point ? 3.0 : 1.0) + glm::dvec3(0.0, 1.5, 0.0));
        result.scene.lighting.lights.push_back(
            is_point ? shading::point_light<float>(place, glm::vec3(0.5f))
                     : shading::directional_light<float>(place, glm::vec3(0.5f)));
    }
    Camera& camera = result.scene.camera;
    camera.target = random.in_cube(0.5);
    const double distance = random.between(1.0, 8.0);
    camera.eye = camera.target + distance * random.direction();
    camera.near = 0.05;
    camera.far = random.below(2) == 0 ? 50.0 : 6.0;  // some things lie beyond
    camera.projection = random.below(4) == 0 ? Projection::orthographic : Projection::perspective;
    if (camera.projection == Projection::orthographic) camera.magnification = 0.3;
    return result;
}

inline Counts counts_of(const Scene& scene, Shadows method, std::size_t light,
                        const raster::Plane<raster::Depth>& depth) {
    Settings settings;
    settings.shadows = method;
    return count_shadows(scene, settings, light, depth);
}

inline int difference(const Counts& a, const Counts& b) {
    int pixels = 0;
    for_each_pixel({a.width(), a.height()},
                   [&](int x, int y) { pixels += a.at(x, y) != b.at(x, y) ? 1 : 0; });
    return pixels;
}

inline constexpr double tolerance = 1e-3;  // of a point that is known by its depth

/// Whether each pixel's point is in shadow by the object-space test.
inline raster::Plane<std::uint8_t> object_space_shadows(const Scene& scene, std::size_t light,
                                                        const raster::Plane<raster::Depth>& depth) {
    const raster::Viewport viewport{depth.width(), depth.height()};
    const Frame frame = frame_of(scene, Distances::finite, viewport);
    const auto shadows = face_shadows(scene.objects, homogeneous(scene.lighting.lights[light]));
    raster::Plane<std::uint8_t> result(viewport, 0);
    for_each_pixel(viewport, [&](int x, int y) {
        if (depth.at(x, y) == raster::depth_clear) return;
        const glm::dvec3 point(frame.point_at(x, y, depth.at(x, y)));
        const glm::dvec3 before = point + glm::dvec3(frame.view_from(point));
        result.at(x, y) = std::ranges::any_of(shadows, [&](const FaceShadow& shadow) {
            // A face that is seen from behind shadows itself.
            return shadow.contains(point, tolerance) ||
                   (shadow.contains(point, -tolerance) &&
                    shadow.behind(before) > shadow.behind(point));
        });
    });
    return result;
}

/// Whether a pixel, not at the border, and all its neighbours have one value.
template <class T>
bool is_even(const raster::Plane<T>& plane, int x, int y) {
    if (x == 0 || y == 0 || x == plane.width() - 1 || y == plane.height() - 1) return false;
    for (int j = y - 1; j <= y + 1; ++j) {
        for (int i = x - 1; i <= x + 1; ++i) {
            if (plane.at(i, j) != plane.at(x, y)) return false;
        }
    }
    return true;
}

/// How the counts agree with the object-space test, away from the shadows' edges.
struct Agreement {
    int compared = 0;
    int shadowed = 0;
    int different = 0;

    Agreement& operator+=(const Agreement& other) {
        compared += other.compared;
        shadowed += other.shadowed;
        different += other.different;
        return *this;
    }
};

inline Agreement agreement(const Scene& scene, Shadows method, std::size_t light,
                           raster::Viewport viewport = {63, 47}, double most_y = 1e30) {
    const Drawing drawing = draw_depth(scene, {}, viewport);
    const auto& depth = drawing.framebuffer.depth;
    const auto expected = object_space_shadows(scene, light, depth);
    const Counts counts = counts_of(scene, method, light, depth);
    const Frame frame = frame_of(scene, Distances::finite, viewport);
    Agreement result;
    for_each_pixel(viewport, [&](int x, int y) {
        if (depth.at(x, y) == raster::depth_clear || !is_even(expected, x, y)) return;
        if (frame.point_at(x, y, depth.at(x, y)).y > most_y) return;
        ++result.compared;
        result.shadowed += expected.at(x, y);
        result.different += (counts.at(x, y) != 0) != (expected.at(x, y) != 0) ? 1 : 0;
    });
    return result;
}

}  // namespace scanlight::render
