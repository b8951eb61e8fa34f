#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "raster/edge.h"
#include "raster/edge_ramps.h"
#include "raster/ramp.h"
#include "raster/vertex.h"

namespace scanlight::raster {

/// The chapter's bilinear interpolation, for polygons of any number of corners: first along the
/// edges, then along the span between two edges (Gouraud 1971 for intensities, Phong 1975 for
/// normals), each by repeated addition:
///
///     I_a += ΔI_a from scanline to scanline,  I_s += ΔI_s from pixel to pixel,
///     ΔI_a = (I_1 - I_2) / (y_1 - y_2),       ΔI_s = (I_b - I_a) / (x_b - x_a).
///
/// The value inside a polygon of more than three corners depends on how it is turned on the
/// screen; that is the method's, and is kept so that it can be seen.
///
/// Steps are rounded to whole multiples of 2^-16 and added exactly: a value n scanlines down its
/// edges and m pixels along its span is off the exact rule by at most (n + m) / 2 + 2 of these, on
/// the largest picture little more than a quarter of a unit. All values lie between the extremes of
/// the corners, once rounded to whole units.
template <int N>
struct Bilinear {
    using EdgeValues = EdgeRamps<N>;

    /// Values where the edge crosses the centre line of `row`, its first; and their steps. An edge
    /// that crosses no other centre line takes no step; its step is only near, see `nearest_whole`.
    EdgeValues down(const ScreenVertex<N>& top, const ScreenVertex<N>& bottom, int row) const {
        const double inverse_height = 1.0 / (bottom.y - top.y);
        const Parts parts{(row * subpixels + half_pixel - top.y) * inverse_height,
                          subpixels * inverse_height};
        EdgeValues edge;
        for (std::size_t k = 0; k < N; ++k) {
            const Number number = number_down(top.attributes[k], bottom.attributes[k], parts);
            edge.attributes[k] = number.value;
            edge.attribute_steps[k] = number.step;
        }
        const Number depth = number_down(top.z, bottom.z, parts);
        edge.depth = depth.value;
        edge.depth_step = depth.step;
        return edge;
    }

    Ramps<N> along(const Edge<EdgeValues>& left, const Edge<EdgeValues>& right, int) const {
        const int steps = right.crossing.column() - left.crossing.column() - 1;
        const double gap = left.crossing.gap();
        // In this order nothing cancels, however narrow the span: it is never less than the gap.
        const double inverse_width = 1.0 / (steps + (right.crossing.reach() + gap));
        // A span of one pixel takes no step; its width may be next to nothing.
        const Parts parts{gap * inverse_width, std::min(steps, 1) * inverse_width};
        Ramps<N> ramps;
        for (std::size_t k = 0; k < N; ++k) {
            ramps.attributes[k] =
                ramp_along(left.values.attributes[k], right.values.attributes[k], parts);
        }
        ramps.depth = ramp_along(left.values.depth, right.values.depth, parts);
        return ramps;
    }

private:
    /// Of the whole way along an edge or a span: what lies before the first centre, and a step.
    /// The former is at most one, and a rounding; too little for a change to be exceeded.
    struct Parts {
        double before_first;
        double step;
    };

    struct Number {
        double value, step;
    };

    static Number number_down(std::int32_t top, std::int32_t bottom, const Parts& parts) {
        constexpr double ramp_one = 1 << ramp_bits;
        const double from = top * ramp_one;
        const double change = bottom * ramp_one - from;
        return {from + nearest_whole(change * parts.before_first),
                nearest_whole(change * parts.step)};
    }

    static Ramp ramp_along(double left, double right, const Parts& parts) {
        const double change = right - left;
        return {plus_nearest(left, change * parts.before_first),
                plus_nearest(0.0, change * parts.step)};
    }
};

}  // namespace scanlight::raster
