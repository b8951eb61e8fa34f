#pragma once

#include <cmath>
#include <cstdint>

#include "raster/edge.h"
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
/// screen; that is the method's, and is kept so that it can be seen. All values lie between the
/// extremes of the corners, and within half a unit of the exact rule before rounding.
template <int N>
struct Bilinear {
    using EdgeValues = Ramps<N>;

    /// Values where the edge crosses the centre line of `row`, its first; and their steps.
    EdgeValues down(const ScreenVertex<N>& top, const ScreenVertex<N>& bottom, int row) const {
        const SubPixel height = bottom.y - top.y;
        const SubPixel offset = row * subpixels + half_pixel - top.y;
        EdgeValues values;
        values.depth = edge_ramp(top.z, bottom.z, offset, height);
        for (std::size_t k = 0; k < N; ++k) {
            values.attributes[k] =
                edge_ramp(top.attributes[k], bottom.attributes[k], offset, height);
        }
        return values;
    }

    Ramps<N> along(const Edge<EdgeValues>& left, const Edge<EdgeValues>& right, int) const {
        const int pixels = right.crossing.column() - left.crossing.column();
        const double gap = left.crossing.gap();
        // In this order nothing cancels, however narrow the span.
        const double width = pixels - 1 + (right.crossing.reach() + gap);
        const SpanScale scale{gap, 1.0 / width, pixels > 1};
        Ramps<N> ramps;
        ramps.depth = span_ramp(left.values.depth, right.values.depth, scale);
        for (std::size_t k = 0; k < N; ++k) {
            ramps.attributes[k] =
                span_ramp(left.values.attributes[k], right.values.attributes[k], scale);
        }
        return ramps;
    }

private:
    /// The pre-step to the first pixel's centre, and 1 / (x_b - x_a), of one span.
    struct SpanScale {
        double gap;
        double inverse_width;
        bool steps;  // a span of one pixel takes no step; its width may be next to nothing
    };

    static Ramp edge_ramp(std::int64_t top, std::int64_t bottom, SubPixel offset, SubPixel height) {
        const std::int64_t change = (bottom - top) << ramp_bits;
        return {(top << ramp_bits) + change * offset / height, change * subpixels / height};
    }

    static Ramp span_ramp(const Ramp& left, const Ramp& right, const SpanScale& scale) {
        const double step = static_cast<double>(right.value - left.value) * scale.inverse_width;
        return {left.value + std::llrint(step * scale.gap), scale.steps ? std::llrint(step) : 0};
    }
};

}  // namespace scanlight::raster
