#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "raster/scan_convert.h"

namespace scanlight::raster {

/// What the walk did to one polygon, step by step, in the textbook's units: pixels, depth in
/// [0, 1], attributes as numbers. Plain data for people to read.
template <int N>
struct Trace {
    using Numbers = std::array<double, N>;

    struct Edge {
        std::uint32_t index;  // from corner `index` to the next one
        int y_begin, y_end;
        double x, dx;  // where it crosses the centre line, and the change a scanline
        double z, dz;
        Numbers values, steps;
    };
    struct Span {
        int x_begin, x_end;
        double z, dz;  // at the first pixel's centre, and the change a pixel
        Numbers values, steps;
    };
    struct Scanline {
        int y;
        std::vector<Edge> active;  // from left to right
        std::vector<Span> spans;
    };

    std::vector<Edge> edge_table;  // in the order of their buckets
    std::vector<Scanline> scanlines;
};

/// The observer that writes a Trace. Works with the bilinear rule, whose edges carry values.
template <int N>
class Tracer {
public:
    explicit Tracer(Trace<N>& trace) : trace_(trace) {}

    void edge_table(const EdgeTable<Ramps<N>>& table) {
        for (const auto& edge : table.edges())
            trace_.edge_table.push_back(noted(edge));
    }
    void scanline(int y, const ActiveEdges<Ramps<N>>& active) {
        trace_.scanlines.push_back({y, {}, {}});
        for (const auto& edge : active.edges()) {
            trace_.scanlines.back().active.push_back(noted(edge));
        }
    }
    void span(const raster::Span<N>& span) {
        typename Trace<N>::Span note{span.x_begin,
                                     span.x_end,
                                     depth_value(span.ramps.depth.value),
                                     depth_value(span.ramps.depth.step_size),
                                     {},
                                     {}};
        note_attributes(span.ramps, note.values, note.steps);
        trace_.scanlines.back().spans.push_back(note);
    }

    // A plane equation's edges carry no values to show.
    template <class Values>
    void edge_table(const EdgeTable<Values>&) {}
    template <class Values>
    void scanline(int y, const ActiveEdges<Values>&) {
        trace_.scanlines.push_back({y, {}, {}});
    }

private:
    static constexpr double ramp_one = 1 << ramp_bits;

    static double depth_value(std::int64_t ramp) {
        return static_cast<double>(ramp) / ramp_one / depth_far;
    }

    static void note_attributes(const Ramps<N>& ramps, std::array<double, N>& values,
                                std::array<double, N>& steps) {
        constexpr double one = ramp_one * static_cast<double>(attribute_one);
        for (std::size_t k = 0; k < N; ++k) {
            values[k] = static_cast<double>(ramps.attributes[k].value) / one;
            steps[k] = static_cast<double>(ramps.attributes[k].step_size) / one;
        }
    }

    static typename Trace<N>::Edge noted(const raster::Edge<Ramps<N>>& edge) {
        typename Trace<N>::Edge note{edge.index,
                                     edge.y_begin,
                                     edge.y_end,
                                     edge.crossing.x(),
                                     edge.crossing.dx(),
                                     depth_value(edge.values.depth.value),
                                     depth_value(edge.values.depth.step_size),
                                     {},
                                     {}};
        note_attributes(edge.values, note.values, note.steps);
        return note;
    }

    Trace<N>& trace_;
};

}  // namespace scanlight::raster
