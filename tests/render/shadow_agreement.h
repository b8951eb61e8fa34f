#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "render/face_shadow.h"
#include "render/shadow_volume.h"
#include "render/shadows.h"
#include "tests/render/scenes.h"

namespace scanlight::render {

using Counts = raster::Plane<std::int32_t>;

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
inline bool is_even(const raster::Plane<std::uint8_t>& plane, int x, int y) {
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
