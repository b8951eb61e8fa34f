#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/build.h"
#include "mesh/shapes.h"
#include "mesh/triangulate.h"
#include "render/draw.h"
#include "render/framing.h"
#include "render/materials.h"

namespace scanlight::render {

/// Seeded random input, the same on every system. The order of calls is part of the input: at most
/// one of them to a function's arguments.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32);
    }
    int below(int end) { return static_cast<int>(between(0.0, end)); }

    glm::dvec3 in_cube(double half_side) {
        const double x = between(-half_side, half_side);
        const double y = between(-half_side, half_side);
        return {x, y, between(-half_side, half_side)};
    }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v = in_cube(1.0);
            const double squared = glm::dot(v, v);
            if (squared > 0.01 && squared < 1.0) return glm::normalize(v);
        }
    }

private:
    std::mt19937 engine_;
};

inline mesh::Mesh shape_mesh(std::string_view shape, const mesh::NormalRule& rule = {}) {
    return mesh::build(mesh::shape(shape), rule).mesh;
}

/// Points only: enough for a camera to be framed by.
inline mesh::Mesh points_mesh(const std::vector<glm::dvec3>& points) {
    mesh::Mesh mesh;
    for (const glm::dvec3& p : points) {
        mesh.vertices.x.push_back(static_cast<float>(p.x));
        mesh.vertices.y.push_back(static_cast<float>(p.y));
        mesh.vertices.z.push_back(static_cast<float>(p.z));
    }
    return mesh;
}

inline shading::Material<float> plastic() {
    return {glm::vec3(0.5f, 0.2f, 0.1f), glm::vec3(0.5f, 0.3f, 0.2f), glm::vec3(0.25f), 20.0};
}

inline Object object_of(const mesh::Mesh& mesh,
                        const shading::Material<float>& material = plastic()) {
    return {&mesh, {mesh.materials.size(), material}};
}

inline shading::Light<float> white_light(const glm::vec3& towards) {
    return shading::directional_light<float>(towards, glm::vec3(0.9f));
}

struct View {
    ViewAngles angles;
    raster::Viewport size{64, 48};
    Projection projection = Projection::perspective;
};

/// The meshes framed, under one white light from the upper left.
inline Scene scene_of(std::vector<Object> objects, const View& view) {
    Scene scene;
    scene.objects = std::move(objects);
    scene.camera.projection = view.projection;
    scene.camera.eye = direction_of(view.angles);
    scene.camera = framed(scene.camera, scene.objects,
                          static_cast<double>(view.size.width) / view.size.height);
    scene.lighting = {glm::vec3(0.1f), {white_light(glm::vec3(-0.5f, 0.7f, 1.0f))}};
    return scene;
}

inline Scene scene_of(const mesh::Mesh& mesh, const View& view) {
    return scene_of(std::vector{object_of(mesh)}, view);
}

/// Where a point of the world lies on the picture (pixels, y down) and its depth 0 to 1, in double.
inline glm::dvec3 screen_from_world(const Camera& camera, raster::Viewport size,
                                    const glm::dvec3& point) {
    const double aspect = static_cast<double>(size.width) / size.height;
    const glm::dvec4 clip =
        clip_from_eye(camera, aspect) * eye_from_world(camera) * glm::dvec4(point, 1.0);
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    return {(ndc.x + 1.0) * 0.5 * size.width, (1.0 - ndc.y) * 0.5 * size.height, ndc.z};
}

/// Calls `visit(x, y)` for each pixel, row by row.
template <class Visit>
void for_each_pixel(raster::Viewport size, Visit&& visit) {
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            visit(x, y);
    }
}

inline std::size_t covered_pixels(const raster::Plane<raster::Depth>& depth) {
    std::size_t count = 0;
    for (const raster::Depth z : depth.values())
        count += z != raster::depth_clear ? 1 : 0;
    return count;
}

/// The largest difference of two pictures of one size in any channel.
inline float largest_difference(const raster::Plane<raster::Rgba>& a,
                                const raster::Plane<raster::Rgba>& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        const raster::Rgba off = glm::abs(a.values()[i] - b.values()[i]);
        largest = std::max({largest, off.r, off.g, off.b, off.a});
    }
    return largest;
}

inline std::size_t different_pixels(const raster::Framebuffer& a, const raster::Framebuffer& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.color.values().size(); ++i) {
        count += a.color.values()[i] != b.color.values()[i] ? 1 : 0;
    }
    return count;
}

inline constexpr std::array all_shadings{Shading::flat, Shading::gouraud, Shading::phong};
inline constexpr std::array all_projections{Projection::perspective, Projection::orthographic};

/// Closed bodies and open sheets, of triangles, quads and larger polygons.
inline constexpr std::array<std::string_view, 7> closed_shapes{
    "cube", "tetrahedron", "icosphere:2", "sphere:12,6", "torus:12,8", "cylinder:9", "cone:7"};

}  // namespace scanlight::render
