#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "raster/framebuffer.h"
#include "raster/span.h"

namespace scanlight::raster {

/// What a polygon has at one pixel.
template <int N>
struct Fragment {
    int x = 0;
    int y = 0;
    Depth depth = 0;
    std::array<float, N> attributes;
};

template <int N>
Fragment<N> fragment_at(int x, int y, Depth depth, const Ramps<N>& ramps) {
    Fragment<N> fragment{x, y, depth, {}};
    for (std::size_t k = 0; k < N; ++k) {
        fragment.attributes[k] = float_from_attribute(ramps.attributes[k].get());
    }
    return fragment;
}

/// The z-buffer (Catmull 1974): each pixel of the span that is nearer than what is there is stored
/// as `shade(fragment)`. At equal depth the first polygon drawn stays. Returns how many passed.
template <int N, class T, class Shade>
std::size_t draw_span(Span<N> span, Plane<Depth>& depth, Plane<T>& target, Shade&& shade) {
    const auto depth_row = depth.row(span.y);
    const auto target_row = target.row(span.y);
    std::size_t passed = 0;
    for (int x = span.x_begin; x < span.x_end; ++x, span.ramps.step()) {
        const auto column = static_cast<std::size_t>(x);
        const Depth z = span.ramps.depth.get();
        if (z >= depth_row[column]) continue;
        depth_row[column] = z;
        target_row[column] = shade(fragment_at<N>(x, span.y, z, span.ramps));
        ++passed;
    }
    return passed;
}

/// One layer of a picture, from pixel to pixel: the nearest surface behind the layer before it. Of
/// surfaces at equal depth the one with the smaller number is the nearer.
template <class T>
struct Layer {
    Plane<Depth> depth;  // where nothing is, that of what ends the layers
    Plane<std::int32_t> number;
    Plane<T> target;

    Layer(Viewport size, const Plane<Depth>& end, const T& nothing)
        : depth(end), number(size, -1), target(size, nothing) {}
};

/// `draw_span` into a layer.
template <int N, class T, class Shade>
std::size_t draw_span_behind(Span<N> span, std::int32_t number, const Plane<Depth>& before_depth,
                             const Plane<std::int32_t>& before_number, Layer<T>& layer,
                             Shade&& shade) {
    std::size_t passed = 0;
    for (int x = span.x_begin; x < span.x_end; ++x, span.ramps.step()) {
        const int y = span.y;
        const Depth z = span.ramps.depth.get();
        const Depth before = before_depth.at(x, y);
        const bool is_behind = z > before || (z == before && number > before_number.at(x, y));
        if (!is_behind || z >= layer.depth.at(x, y)) continue;
        layer.depth.at(x, y) = z;
        layer.number.at(x, y) = number;
        layer.target.at(x, y) = shade(fragment_at<N>(x, y, z, span.ramps));
        ++passed;
    }
    return passed;
}

/// Which fragments a stencil pass counts: those in front of what is drawn, or those not.
enum class StencilCount { where_nearer, where_not_nearer };

/// Adds `change` to the stencil of the pixels chosen by the depth test; depth and colour stay as
/// they are. The counting pass of shadow volumes (Crow 1977).
template <int N>
void count_span(Span<N> span, StencilCount count, std::int32_t change, const Plane<Depth>& depth,
                Plane<std::int32_t>& stencil) {
    const auto depth_row = depth.row(span.y);
    const auto stencil_row = stencil.row(span.y);
    for (int x = span.x_begin; x < span.x_end; ++x, span.ramps.step()) {
        const auto column = static_cast<std::size_t>(x);
        const bool nearer = span.ramps.depth.get() < depth_row[column];
        if (nearer == (count == StencilCount::where_nearer)) stencil_row[column] += change;
    }
}

}  // namespace scanlight::raster
