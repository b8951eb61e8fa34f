#pragma once

#include <span>

#include "raster/active_edges.h"
#include "raster/edge_table.h"
#include "raster/span.h"

namespace scanlight::raster {

/// Sees nothing and costs nothing. An observer is handed the walk's own data at each step; the
/// functions here are the whole of what one may have.
struct NoObserver {
    template <class Values>
    void edge_table(const EdgeTable<Values>&) const {}
    template <class Values>
    void scanline(int, const ActiveEdges<Values>&) const {}
    template <int N>
    void span(const Span<N>&) const {}
};

/// Which parts of a polygon whose edges cross are inside.
enum class FillRule {
    even_odd,  // what a ray from outside reaches through an odd number of edges
    winding,   // what the outline goes round, and how often: see `Span::winding`
};

/// Calls `visit(left, right, winding)` for the pairs of active edges that bound spans.
template <FillRule rule, class Values, class Visit>
void for_each_span(const ActiveEdges<Values>& active, Visit&& visit) {
    if constexpr (rule == FillRule::winding) {
        active.for_each_wound(visit);
    } else {
        active.for_each_pair([&](const auto& left, const auto& right) { visit(left, right, 1); });
    }
}

/// The scanline algorithm of Wylie, Romney, Evans & Erdahl 1967, "Half-tone perspective drawings
/// by computer", with an edge table and an active edge table: goes down the screen, keeps the
/// edges that cross the scanline from left to right, and emits the spans between each pair. The
/// table's edges are stepped on the way: it serves for one walk.
template <int N, FillRule rule = FillRule::even_odd, class Interpolation, class Emit,
          class Observer>
void scan_convert(EdgeTable<typename Interpolation::EdgeValues>& table,
                  ActiveEdges<typename Interpolation::EdgeValues>& active,
                  const Interpolation& interpolation, Emit&& emit, Observer&& observer) {
    active.clear();
    auto waiting = table.edges();
    const int y_end = table.y_end();
    for (int y = table.y_begin(); y < y_end; ++y) {
        waiting = active.admit(waiting, y);
        active.sort_by_x();
        observer.scanline(y, active);
        for_each_span<rule>(active, [&](const auto& left, const auto& right, int winding) {
            const Span<N> span{y, left.crossing.column(), right.crossing.column(),
                               interpolation.along(left, right, y), winding};
            observer.span(span);
            emit(span);
        });
        active.retire_before(y + 1);
        active.step();
    }
}

}  // namespace scanlight::raster
