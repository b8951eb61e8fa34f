#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/edge_ramps.h"
#include "raster/scan_convert.h"

namespace scanlight::raster {

/// What the walk did to one polygon, step by step, in the textbook's units: pixels, depth in
/// [0, 1], attributes as numbers. Plain data for people to read.
struct Trace {
    /// Depth and attributes, and what is added to each on the next scanline or pixel.
    struct Numbers {
        double z = 0.0, dz = 0.0;
        std::vector<double> values, steps;
    };
    struct Edge : Numbers {   // where it crosses the centre line
        std::uint32_t index;  // from corner `index` to the next one
        int y_begin, y_end;
        double x, dx;  // the crossing, and the change a scanline
    };
    struct Span : Numbers {  // at the first pixel's centre
        int x_begin, x_end;
    };
    struct Scanline {
        int y;
        std::vector<Edge> active;  // from left to right
        std::vector<Span> spans;
    };

    std::vector<Edge> edge_table;  // in the order of their buckets
    std::vector<Scanline> scanlines;
};

/// The observer that writes a Trace, of the first `shown` attributes. Works with the bilinear rule:
/// a plane equation's edges carry no values to show.
template <int N>
class Tracer {
public:
    explicit Tracer(Trace& trace, std::size_t shown = N) : trace_(trace), shown_(shown) {}

    void edge_table(const EdgeTable<EdgeRamps<N>>& table) {
        for (const auto& edge : table.edges())
            trace_.edge_table.push_back(noted(edge));
    }
    void scanline(int y, const ActiveEdges<EdgeRamps<N>>& active) {
        trace_.scanlines.push_back({y, {}, {}});
        for (const auto* edge : active.edges())
            trace_.scanlines.back().active.push_back(noted(*edge));
    }
    void span(const raster::Span<N>& span) {
        trace_.scanlines.back().spans.push_back({noted(span.ramps), span.x_begin, span.x_end});
    }

    template <class Values>
    void edge_table(const EdgeTable<Values>&) {}
    template <class Values>
    void scanline(int y, const ActiveEdges<Values>&) {
        trace_.scanlines.push_back({y, {}, {}});
    }

private:
    static constexpr double ramp_one = 1 << ramp_bits;
    static constexpr double depth_one = ramp_one * depth_far;
    static constexpr double value_one = ramp_one * static_cast<double>(attribute_one);

    Trace::Numbers noted(const Ramps<N>& ramps) const {
        Trace::Numbers note{static_cast<double>(ramps.depth.value) / depth_one,
                            static_cast<double>(ramps.depth.step_size) / depth_one,
                            {},
                            {}};
        for (std::size_t k = 0; k < shown_; ++k) {
            note.values.push_back(static_cast<double>(ramps.attributes[k].value) / value_one);
            note.steps.push_back(static_cast<double>(ramps.attributes[k].step_size) / value_one);
        }
        return note;
    }

    Trace::Numbers noted(const EdgeRamps<N>& ramps) const {
        Trace::Numbers note{ramps.depth / depth_one, ramps.depth_step / depth_one, {}, {}};
        for (std::size_t k = 0; k < shown_; ++k) {
            note.values.push_back(ramps.attributes[k] / value_one);
            note.steps.push_back(ramps.attribute_steps[k] / value_one);
        }
        return note;
    }

    Trace::Edge noted(const raster::Edge<EdgeRamps<N>>& edge) const {
        return {noted(edge.values), edge.index,        edge.y_begin,
                edge.y_end,         edge.crossing.x(), edge.crossing.dx()};
    }

    Trace& trace_;
    std::size_t shown_;
};

}  // namespace scanlight::raster
