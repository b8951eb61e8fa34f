#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/fill.h"
#include "raster/framebuffer.h"
#include "tests/raster/random_polygons.h"

namespace scanlight::raster {

// Bit by bit, so that laws can demand the same bits.
inline bool operator==(const Ramp& a, const Ramp& b) {
    return a.value == b.value && a.step_size == b.step_size;
}

template <int N>
bool operator==(const Ramps<N>& a, const Ramps<N>& b) {
    return a.depth == b.depth && a.attributes == b.attributes;
}

template <int N>
bool operator==(const Span<N>& a, const Span<N>& b) {
    return a.y == b.y && a.x_begin == b.x_begin && a.x_end == b.x_end && a.ramps == b.ramps;
}

}  // namespace scanlight::raster

namespace scanlight::raster::laws {

/// How often each pixel was covered.
using Counts = Plane<int>;

inline Counts no_counts(int size) {
    return Counts({size, size}, 0);
}

/// Counts the pixels that polygons cover.
class Counter {
public:
    void add(const Points& polygon, Counts& counts) { add(without_values<0>(polygon), counts); }

    template <int N>
    void add(const std::vector<ScreenVertex<N>>& polygon, Counts& counts) {
        corners_.clear();
        for (const auto& v : polygon)
            corners_.push_back({v.x, v.y, 0, {}});
        filler_.fill(corners_, Interpolation::bilinear, [&counts](const Span<0>& span) {
            const auto row = counts.row(span.y);
            for (int x = span.x_begin; x < span.x_end; ++x)
                ++row[static_cast<std::size_t>(x)];
        });
    }

private:
    PolygonFiller<0> filler_;
    std::vector<ScreenVertex<0>> corners_;
};

template <int N>
std::vector<Span<N>> spans_of(PolygonFiller<N>& filler, const std::vector<ScreenVertex<N>>& polygon,
                              Interpolation interpolation) {
    std::vector<Span<N>> spans;
    filler.fill(polygon, interpolation, [&spans](const Span<N>& span) { spans.push_back(span); });
    return spans;
}

template <int N>
std::vector<Span<N>> spans_of(const std::vector<ScreenVertex<N>>& polygon,
                              Interpolation interpolation) {
    PolygonFiller<N> filler;
    return spans_of(filler, polygon, interpolation);
}

/// What a ramp holds `pixels` pixels further on.
inline Ramp ahead(Ramp ramp, int pixels) {
    return {ramp.value + pixels * ramp.step_size, ramp.step_size};
}

}  // namespace scanlight::raster::laws
