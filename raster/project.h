#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "raster/vertex.h"

namespace scanlight::raster {

/// Picture size in pixels, 1 to `max_size` each way.
struct Viewport {
    int width = 0;
    int height = 0;
};

inline SubPixel snap(float pixels, int size) {
    const float limit = static_cast<float>(size);
    return static_cast<SubPixel>(
        std::lrint(clamped(pixels, 0.0f, limit) * static_cast<float>(subpixels)));
}

/// Divides by w and snaps to 1/256 pixel. Screen y grows downward. The vertex has been clipped, or
/// lies beyond the far plane by no more than `deepest`.
template <int N>
ScreenVertex<N> snapped(const glm::vec4& p, const Viewport& viewport, float deepest = 1.0f) {
    const float half_width = 0.5f * static_cast<float>(viewport.width);
    const float half_height = 0.5f * static_cast<float>(viewport.height);
    ScreenVertex<N> v;
    v.x = snap((p.x / p.w + 1.0f) * half_width, viewport.width);
    v.y = snap((1.0f - p.y / p.w) * half_height, viewport.height);
    v.z = depth_from_ndc(p.z / p.w, deepest);
    return v;
}

/// Projects each corner, its attributes multiplied by `scale(position)`.
template <int N, class Scale>
std::vector<ScreenVertex<N>> project_scaled(const std::vector<ClipVertex<N>>& polygon,
                                            const Viewport& viewport, Scale&& scale) {
    std::vector<ScreenVertex<N>> result;
    result.reserve(polygon.size());
    for (const auto& vertex : polygon) {
        auto v = snapped<N>(vertex.position, viewport);
        const float factor = scale(vertex.position);
        for (std::size_t k = 0; k < N; ++k) {
            v.attributes[k] = attribute_from_float(vertex.attributes[k] * factor);
        }
        result.push_back(v);
    }
    return result;
}

/// The chapter's projection: attributes will be interpolated evenly over the screen.
template <int N>
std::vector<ScreenVertex<N>> project_affine(const std::vector<ClipVertex<N>>& polygon,
                                            const Viewport& viewport) {
    return project_scaled(polygon, viewport, [](const glm::vec4&) { return 1.0f; });
}

/// The cure for the chapter's unequal perspective spacing: a/w and 1/w are even over the screen
/// where a is not. Attributes are stored times q = w_min / w, which lies in (0, 1]. An attribute
/// that is 1 at each corner becomes q itself, so that a = (a q) / q at each pixel; a direction
/// needs no division, for (a q) points the same way.
template <int N>
std::vector<ScreenVertex<N>> project_correct(const std::vector<ClipVertex<N>>& polygon,
                                             const Viewport& viewport) {
    float w_min = polygon.empty() ? 1.0f : polygon.front().position.w;
    for (const auto& vertex : polygon)
        w_min = std::min(w_min, vertex.position.w);
    return project_scaled(polygon, viewport,
                          [w_min](const glm::vec4& position) { return w_min / position.w; });
}

/// Twice the signed area on the screen in 1/65536 square pixels, exact. Positive for polygons that
/// run counter-clockwise as seen on the screen, whose y grows downward.
template <int N>
std::int64_t signed_area(const std::vector<ScreenVertex<N>>& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        sum += std::int64_t{a.y} * b.x - std::int64_t{a.x} * b.y;
    }
    return sum;
}

}  // namespace scanlight::raster
