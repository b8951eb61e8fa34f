#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "apps/bench/float_vertex.h"
#include "apps/bench/pixels.h"
#include "apps/bench/target.h"
#include "apps/bench/walk.h"
#include "raster/fill.h"
#include "raster/fragments.h"

namespace scanlight::bench {

// The ways from a polygon's corners to the values at its pixels that are measured against each
// other. All cover the same pixels, test depth, and call `shade` for what passes.

template <int N>
using Corners = std::span<const raster::ScreenVertex<N>>;

/// What no method can do without: read z, compare, write z and colour. Nothing is interpolated.
template <int N>
class BareLoop {
public:
    using Z = float;

    template <class Shade>
    void draw(Corners<N> polygon, Target<Z>& target, Shade&& shade) {
        walk_(polygon, [&](int y, const auto& left, const auto& right) {
            draw_pixels<N>(
                y, left.crossing.column(), right.crossing.column(), target,
                [](float) { return FloatValues<N>{}; }, shade);
        });
    }

private:
    Walk walk_;
};

/// The library: each value is the one before it plus an increment.
template <int N, raster::Interpolation interpolation>
class Incremental {
public:
    using Z = raster::Depth;

    template <class Shade>
    void draw(Corners<N> polygon, Target<Z>& target, Shade&& shade) {
        filler_.fill(polygon, interpolation, [&](const raster::Span<N>& span) {
            raster::draw_span(span, target.depth, target.color, shade);
        });
    }

private:
    raster::PolygonFiller<N> filler_;
};

/// Increments down the edges and along each span: the textbook's.
template <int N>
using IncrementalEdges = Incremental<N, raster::Interpolation::bilinear>;

/// One pair of increments for the whole triangle.
template <int N>
using IncrementalPlane = Incremental<N, raster::Interpolation::planar>;

/// The bilinear formulas evaluated anew: at each scanline for the two edges (1 and 2 are the ends
/// of one of them), at each pixel between them.
///     I_a = I_1 + (y - y_1)/(y_2 - y_1) (I_2 - I_1),  I_s = I_a + (x - x_a)/(x_b - x_a) (I_b -
///     I_a)
template <int N>
class DirectBilinear {
public:
    using Z = float;

    template <class Shade>
    void draw(Corners<N> polygon, Target<Z>& target, Shade&& shade) {
        corners_.clear();
        for (const auto& corner : polygon)
            corners_.push_back(in_floats(corner));
        walk_(polygon, [&](int y, const auto& left, const auto& right) {
            const FloatVertex<N> a = on_edge(left.index, y);
            const FloatVertex<N> b = on_edge(right.index, y);
            const auto values_at = [&](float x) {
                return between(a.values, b.values, (x - a.x) / (b.x - a.x));
            };
            draw_pixels<N>(y, left.crossing.column(), right.crossing.column(), target, values_at,
                           shade);
        });
    }

private:
    FloatVertex<N> on_edge(std::size_t index, int row) const {
        const auto& from = corners_[index];
        const auto& to = corners_[index + 1 < corners_.size() ? index + 1 : 0];
        const float y = static_cast<float>(row) + 0.5f;
        const float t = (y - from.y) / (to.y - from.y);
        return {from.x + t * (to.x - from.x), y, between(from.values, to.values, t)};
    }

    Walk walk_;
    std::vector<FloatVertex<N>> corners_;
};

/// Barycentric weights from the edge functions of Pineda 1988, "A parallel algorithm for polygon
/// rasterization", evaluated at each pixel; triangles only.
template <int N>
class Barycentric {
public:
    using Z = float;

    template <class Shade>
    void draw(Corners<N> polygon, Target<Z>& target, Shade&& shade) {
        const std::array corners{in_floats(polygon[0]), in_floats(polygon[1]),
                                 in_floats(polygon[2])};
        const FloatVertex<N>& a = corners[0];
        const FloatVertex<N>& b = corners[1];
        const FloatVertex<N>& c = corners[2];
        const float inverse_area = 1.0f / edge_function(a, b, c.x, c.y);
        walk_(polygon, [&](int row, const auto& left, const auto& right) {
            const float y = static_cast<float>(row) + 0.5f;
            const auto values_at = [&](float x) {
                const float weight_a = edge_function(b, c, x, y) * inverse_area;
                const float weight_b = edge_function(c, a, x, y) * inverse_area;
                const float weight_c = edge_function(a, b, x, y) * inverse_area;
                return weighted(corners, {weight_a, weight_b, weight_c});
            };
            draw_pixels<N>(row, left.crossing.column(), right.crossing.column(), target, values_at,
                           shade);
        });
    }

private:
    /// Twice the signed area of the triangle (p, q, (x, y)).
    static float edge_function(const FloatVertex<N>& p, const FloatVertex<N>& q, float x, float y) {
        return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    }

    static FloatValues<N> weighted(const std::array<FloatVertex<N>, 3>& corners,
                                   const std::array<float, 3>& weights) {
        FloatValues<N> result;
        for (std::size_t i = 0; i < 3; ++i) {
            result.z += weights[i] * corners[i].values.z;
            for (std::size_t k = 0; k < N; ++k) {
                result.attributes[k] += weights[i] * corners[i].values.attributes[k];
            }
        }
        return result;
    }

    Walk walk_;
};

}  // namespace scanlight::bench
