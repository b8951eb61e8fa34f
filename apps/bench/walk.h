#pragma once

#include <span>

#include "raster/active_edges.h"
#include "raster/edge_table.h"
#include "raster/vertex.h"

namespace scanlight::bench {

/// The library's walk down the edges without anything to interpolate: it finds the pixels, and the
/// edges on either side of them, for the methods that work out each pixel's values anew.
class Walk {
public:
    /// Calls `visit(y, left, right)` with the two edges of each span.
    template <int N, class Visit>
    void operator()(std::span<const raster::ScreenVertex<N>> polygon, Visit&& visit) {
        table_.build(polygon, [](const auto&, const auto&, int) { return Nothing{}; });
        active_.clear();
        auto waiting = table_.edges();
        const int y_end = table_.y_end();
        for (int y = table_.y_begin(); y < y_end; ++y) {
            waiting = active_.admit(waiting, y);
            active_.sort_by_x();
            active_.for_each_pair(
                [&](const auto& left, const auto& right) { visit(y, left, right); });
            active_.retire_before(y + 1);
            active_.step();
        }
    }

private:
    struct Nothing {
        void step() {}
        void step(int) {}
    };

    raster::EdgeTable<Nothing> table_;
    raster::ActiveEdges<Nothing> active_;
};

}  // namespace scanlight::bench
