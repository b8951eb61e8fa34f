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
///
/// Which edges of a small polygon cross a centre line, and which of them begins first, no processor
/// can foresee: all edges are ordered before any is set up, and without branches.
template <class Values>
class EdgeTable {
public:
    /// `values_down(top, bottom, row)` gives what the edge carries on its first scanline. What lies
    /// outside `rows` is left out; inside, nothing changes by that.
    template <int N, class ValuesDown>
    void build(std::span<const ScreenVertex<N>> polygon, ValuesDown&& values_down, Rows rows = {}) {
        find_order(polygon, rows);
        if (edges_.size() < count_) edges_.resize(count_);
        for (std::size_t place = 0; place < count_; ++place) {
            const auto index = static_cast<std::uint32_t>(order_[place]);
            const auto& a = polygon[index];
            const auto& b = polygon[index + 1 < polygon.size() ? index + 1 : 0];
            const bool downward = a.y < b.y;
            set(edges_[place], downward ? a : b, downward ? b : a, rows, values_down);
            edges_[place].index = index;
            edges_[place].winding = downward ? 1 : -1;
        }
    }

    bool empty() const { return count_ == 0; }
    int y_begin() const { return empty() ? 0 : edges_.front().y_begin; }
    int y_end() const {
        int end = y_begin();
        for (const auto& edge : edges())
            end = std::max(end, edge.y_end);
        return end;
    }

    /// All edges, in the order in which they become active.
    std::span<const Edge<Values>> edges() const { return {edges_.data(), count_}; }
    std::span<Edge<Values>> edges() { return {edges_.data(), count_}; }

private:
    /// Where an edge stands in the table: its first scanline, then its index. Last, if nowhere.
    using Place = std::uint64_t;
    static constexpr Place nowhere = ~Place{0};

    static Place place_of(std::size_t index, int row_a, int row_b) {
        const auto y_begin = static_cast<std::uint32_t>(std::min(row_a, row_b));
        const Place place = Place{y_begin} << 32 | index;
        return row_a != row_b ? place : nowhere;
    }

    /// The scanline at which an edge from or to this corner begins or ends.
    static int row_of(SubPixel y, Rows rows) {
        return std::clamp(first_centre(y), rows.y_begin, rows.y_end);
    }

    template <int N>
    void find_order(std::span<const ScreenVertex<N>> polygon, Rows rows) {
        order_.resize(polygon.size());
        count_ = 0;
        if (polygon.empty()) return;
        int row_b = row_of(polygon.front().y, rows);
        for (std::size_t i = polygon.size(); i-- > 0;) {
            const int row_a = row_of(polygon[i].y, rows);
            order_[i] = place_of(i, row_a, row_b);
            count_ += row_a != row_b ? 1 : 0;
            row_b = row_a;
        }
        constexpr std::size_t few = 16;
        if (order_.size() <= few) {
            sort_few();
        } else {
            std::ranges::sort(order_);
        }
    }

    void sort_few() {
        for (std::size_t i = 1; i < order_.size(); ++i) {
            for (std::size_t j = i; j > 0; --j) {
                const Place a = order_[j - 1];
                const Place b = order_[j];
                order_[j - 1] = std::min(a, b);
                order_[j] = std::max(a, b);
            }
        }
    }

    template <int N, class ValuesDown>
    static void set(Edge<Values>& edge, const ScreenVertex<N>& top, const ScreenVertex<N>& bottom,
                    Rows rows, ValuesDown& values_down) {
        const int first = first_centre(top.y);
        edge.y_begin = std::max(first, rows.y_begin);
        edge.y_end = std::min(first_centre(bottom.y), rows.y_end);
        edge.crossing = Crossing({top.x, top.y}, {bottom.x, bottom.y}, edge.y_begin);
        edge.values = values_down(top, bottom, first);
        if (edge.y_begin > first) edge.values.step(edge.y_begin - first);
    }

    std::vector<Place> order_;
    std::vector<Edge<Values>> edges_;  // the first `count_` of them
    std::size_t count_ = 0;
};

}  // namespace scanlight::raster
