#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raster/bilinear.h"
#include "raster/plane.h"
#include "raster/scan_convert.h"
#include "raster/vertex.h"

namespace scanlight::raster {

/// How values get from a polygon's corners to its pixels. (Triangulating n-gons beforehand is
/// `mesh`'s affair.)
enum class Interpolation {
    bilinear,  // along edges, then along spans: the textbook's, for any polygon
    planar,    // by the plane equation for triangles; n-gons stay bilinear
};

/// Turns polygons of N attributes into spans. Any simple polygon, convex or concave, clockwise or
/// not; where edges cross, the fill rule decides. A pixel is covered when its centre lies inside;
/// a centre on an edge belongs to the polygon right of or below the edge (top-left rule), so the
/// polygons of a tiling cover each pixel exactly once. Keeps scratch memory from one polygon to the
/// next; not for two threads at once.
template <int N, FillRule rule = FillRule::even_odd>
class PolygonFiller {
public:
    /// Calls `emit(const Span<N>&)` from top to bottom and left to right, for the spans in `rows`.
    template <class Emit, class Observer = NoObserver>
    void fill(std::span<const ScreenVertex<N>> polygon, Interpolation interpolation, Emit&& emit,
              Observer&& observer = {}, Rows rows = {}) {
        if (interpolation == Interpolation::planar && polygon.size() == 3) {
            if (const auto planar = Planar<N>::of(polygon)) {
                walk(polygon, rows, *planar, planar_edges_, emit, observer);
                return;
            }
        }
        walk(polygon, rows, Bilinear<N>{}, bilinear_edges_, emit, observer);
    }

private:
    template <class Values>
    struct Edges {
        EdgeTable<Values> table;
        ActiveEdges<Values> active;
    };

    template <class Values, class Emit, class Observer>
    void walk(std::span<const ScreenVertex<N>> polygon, Rows rows, const Values& values,
              Edges<typename Values::EdgeValues>& edges, Emit& emit, Observer& observer) {
        const auto down = [&](const auto& top, const auto& bottom, int row) {
            return values.down(top, bottom, row);
        };
        edges.table.build(polygon, down, rows);
        observer.edge_table(edges.table);
        scan_convert<N, rule>(edges.table, edges.active, values, emit, observer);
    }

    Edges<typename Bilinear<N>::EdgeValues> bilinear_edges_;
    Edges<typename Planar<N>::EdgeValues> planar_edges_;
};

}  // namespace scanlight::raster
