#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/edge.h"
#include "raster/rows.h"
#include "raster/vertex.h"

namespace scanlight::raster {

/// The edges of one polygon, bucketed by the scanline on which each begins: an array sorted by
/// that scanline, of which each bucket is a part. Edges that cross no centre line (horizontal ones
/// and those between two centres) are left out. Memory is kept from one polygon to the next.
template <class Values>
class EdgeTable {
public:
    /// `values_down(top, bottom, row)` gives what the edge carries on its first scanline. What lies
    /// outside `rows` is left out; inside, nothing changes by that.
    template <int N, class ValuesDown>
    void build(std::span<const ScreenVertex<N>> polygon, ValuesDown&& values_down, Rows rows = {}) {
        edges_.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const auto& a = polygon[i];
            const auto& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            const bool downward = a.y < b.y;
            add(downward ? a : b, downward ? b : a, static_cast<std::uint32_t>(i), rows,
                values_down);
        }
        std::sort(edges_.begin(), edges_.end(), begins_before);
    }

    bool empty() const { return edges_.empty(); }
    int y_begin() const { return empty() ? 0 : edges_.front().y_begin; }
    int y_end() const {
        int end = y_begin();
        for (const auto& edge : edges_)
            end = std::max(end, edge.y_end);
        return end;
    }

    /// All edges, in the order in which they become active.
    std::span<const Edge<Values>> edges() const { return edges_; }

private:
    template <int N, class ValuesDown>
    void add(const ScreenVertex<N>& top, const ScreenVertex<N>& bottom, std::uint32_t index,
             Rows rows, ValuesDown& values_down) {
        const int first = first_centre(top.y);
        const int y_begin = std::max(first, rows.y_begin);
        const int y_end = std::min(first_centre(bottom.y), rows.y_end);
        if (y_begin >= y_end) return;
        Values values = values_down(top, bottom, first);
        values.step(y_begin - first);
        edges_.push_back({y_begin, y_end, Crossing({top.x, top.y}, {bottom.x, bottom.y}, y_begin),
                          values, index});
    }

    static bool begins_before(const Edge<Values>& a, const Edge<Values>& b) {
        if (a.y_begin != b.y_begin) return a.y_begin < b.y_begin;
        return a.index < b.index;
    }

    std::vector<Edge<Values>> edges_;
};

}  // namespace scanlight::raster
