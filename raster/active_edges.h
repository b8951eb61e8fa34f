#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "raster/edge.h"

namespace scanlight::raster {

/// The edges that cross the current scanline, from left to right: the active edge table.
/// Polygons are closed, so their number is always even; pairs bound the spans (even-odd rule).
/// Links to edges of the edge table, which is where they are stepped down.
template <class Values>
class ActiveEdges {
public:
    void clear() {
        edges_.clear();
        y_first_end_ = max_size;
    }

    /// Takes over the bucket of scanline `y` from `waiting`; returns what still waits.
    std::span<Edge<Values>> admit(std::span<Edge<Values>> waiting, int y) {
        std::size_t count = 0;
        for (; count < waiting.size() && waiting[count].y_begin == y; ++count) {
            edges_.push_back(&waiting[count]);
            y_first_end_ = std::min(y_first_end_, waiting[count].y_end);
        }
        return waiting.subspan(count);
    }

    /// Insertion sort: from one scanline to the next the order hardly ever changes.
    void sort_by_x() {
        if (edges_.size() == 2) return sort_pair();
        for (std::size_t i = 1; i < edges_.size(); ++i) {
            for (std::size_t j = i; j > 0 && precedes(*edges_[j], *edges_[j - 1]); --j) {
                std::swap(edges_[j], edges_[j - 1]);
            }
        }
    }

    /// Calls `visit(left, right)` for each pair that encloses at least one pixel centre.
    template <class Visit>
    void for_each_pair(Visit&& visit) const {
        assert(edges_.size() % 2 == 0 && "a closed polygon crosses a line an even number of times");
        for (std::size_t i = 0; i + 1 < edges_.size(); i += 2) {
            const Edge<Values>& left = *edges_[i];
            const Edge<Values>& right = *edges_[i + 1];
            if (left.crossing.column() < right.crossing.column()) visit(left, right);
        }
    }

    /// Calls `visit(left, right, winding)` for each stretch between neighbours that the outline
    /// goes round: so often, counter-clockwise on the screen positive (non-zero winding rule).
    template <class Visit>
    void for_each_wound(Visit&& visit) const {
        std::int32_t winding = 0;
        for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
            const Edge<Values>& left = *edges_[i];
            const Edge<Values>& right = *edges_[i + 1];
            winding += left.winding;
            if (winding != 0 && left.crossing.column() < right.crossing.column())
                visit(left, right, winding);
        }
    }

    /// Drops the edges that have ended before scanline `y`.
    void retire_before(int y) {
        if (y < y_first_end_) return;
        std::size_t kept = 0;
        y_first_end_ = max_size;
        for (auto* edge : edges_) {
            const bool stays = edge->y_end > y;
            edges_[kept] = edge;
            kept += stays ? 1 : 0;  // no branch: which edge ends first could not be foreseen
            y_first_end_ = std::min(y_first_end_, stays ? edge->y_end : max_size);
        }
        edges_.resize(kept);
    }

    void step() {
        for (auto* edge : edges_)
            edge->step();
    }

    std::span<const Edge<Values>* const> edges() const { return edges_; }

private:
    /// All there is to sort in a convex polygon.
    void sort_pair() {
        Edge<Values>* const a = edges_[0];
        Edge<Values>* const b = edges_[1];
        const bool in_order = !precedes(*b, *a);
        edges_[0] = in_order ? a : b;
        edges_[1] = in_order ? b : a;
    }

    static bool precedes(const Edge<Values>& a, const Edge<Values>& b) {
        if (left_of(a.crossing, b.crossing)) return true;
        if (left_of(b.crossing, a.crossing)) return false;
        return a.index < b.index;  // edges that lie on one another
    }

    std::vector<Edge<Values>*> edges_;
    int y_first_end_ = max_size;  // before it nothing is to retire
};

}  // namespace scanlight::raster
