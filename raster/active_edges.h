#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "raster/edge.h"

namespace scanlight::raster {

/// The edges that cross the current scanline, from left to right: the active edge table.
/// Polygons are closed, so their number is always even; pairs bound the spans (even-odd rule).
template <class Values>
class ActiveEdges {
public:
    void clear() { edges_.clear(); }

    /// Takes over the bucket of scanline `y` from `waiting`; returns what still waits.
    std::span<const Edge<Values>> admit(std::span<const Edge<Values>> waiting, int y) {
        std::size_t count = 0;
        while (count < waiting.size() && waiting[count].y_begin == y)
            ++count;
        edges_.insert(edges_.end(), waiting.begin(),
                      waiting.begin() + static_cast<std::ptrdiff_t>(count));
        return waiting.subspan(count);
    }

    /// Insertion sort: from one scanline to the next the order hardly ever changes.
    void sort_by_x() {
        for (std::size_t i = 1; i < edges_.size(); ++i) {
            for (std::size_t j = i; j > 0 && precedes(edges_[j], edges_[j - 1]); --j) {
                std::swap(edges_[j], edges_[j - 1]);
            }
        }
    }

    /// Calls `visit(left, right)` for each pair that encloses at least one pixel centre.
    template <class Visit>
    void for_each_pair(Visit&& visit) const {
        assert(edges_.size() % 2 == 0 && "a closed polygon crosses a line an even number of times");
        for (std::size_t i = 0; i + 1 < edges_.size(); i += 2) {
            if (edges_[i].crossing.column() < edges_[i + 1].crossing.column()) {
                visit(edges_[i], edges_[i + 1]);
            }
        }
    }

    void retire_before(int y) {
        std::erase_if(edges_, [y](const auto& edge) { return edge.y_end <= y; });
    }

    void step() {
        for (auto& edge : edges_)
            edge.step();
    }

    std::span<const Edge<Values>> edges() const { return edges_; }

private:
    static bool precedes(const Edge<Values>& a, const Edge<Values>& b) {
        if (left_of(a.crossing, b.crossing)) return true;
        if (left_of(b.crossing, a.crossing)) return false;
        return a.index < b.index;  // edges that lie on one another
    }

    std::vector<Edge<Values>> edges_;
};

}  // namespace scanlight::raster
