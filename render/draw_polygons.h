#pragma once

#include <cstddef>
#include <span>

#include "raster/fill.h"
#include "raster/fragments.h"
#include "render/screen_polygons.h"

namespace scanlight::render {

/// What became of the polygons and pixels of a pass: polygons = outside + culled + drawn.
struct DrawCounts {
    std::size_t polygons = 0;
    std::size_t outside = 0;  // nothing of them inside the view volume
    std::size_t culled = 0;
    std::size_t drawn = 0;
    std::size_t spans = 0;
    std::size_t pixels_tested = 0;  // by the fast path: without those of polygons hidden whole
    std::size_t pixels_passed = 0;
    std::size_t pixels_shaded = 0;  // lit; where lighting waits, each pixel once

    DrawCounts& operator+=(const DrawCounts& other);
};

inline void count_fate(DrawCounts& counts, Fate fate) {
    ++counts.polygons;
    if (fate == Fate::outside) ++counts.outside;
    if (fate == Fate::culled) ++counts.culled;
    if (fate == Fate::seen) ++counts.drawn;
}

/// Takes the spans of one mesh's polygons, in their order, by a technique (see `ScreenPolygons`):
/// `draw_span(face, span, shade)` returns how many of its pixels passed.
template <class Technique, class DrawSpan>
DrawCounts draw_polygons(const PlacedMesh& placed, const Technique& technique, const Frame& frame,
                         const Settings& settings, DrawSpan&& draw_span) {
    constexpr int N = Technique::attribute_count;
    const ScreenPolygons<Technique> polygons(placed, technique, frame, settings);
    raster::PolygonFiller<N> filler;
    DrawCounts counts;
    for (std::size_t face = 0; face < placed.mesh->face_count(); ++face) {
        const ScreenPolygon<N> polygon = polygons[face];
        count_fate(counts, polygon.fate);
        if (polygon.fate != Fate::seen) continue;
        const auto& common = technique.polygon(face, polygon.side);
        const auto shade = [&](const raster::Fragment<N>& fragment) {
            return technique.shade(fragment, common);
        };
        const auto draw = [&](const raster::Span<N>& span) {
            ++counts.spans;
            counts.pixels_tested += static_cast<std::size_t>(span.x_end - span.x_begin);
            counts.pixels_passed += draw_span(face, span, shade);
        };
        filler.fill(std::span(polygon.corners), raster::Interpolation::planar, draw);
    }
    counts.pixels_shaded = counts.pixels_passed;  // lit as soon as they are seen
    return counts;
}

/// Draws them by the z-buffer.
template <class Technique>
DrawCounts draw_polygons(const PlacedMesh& placed, const Technique& technique, const Frame& frame,
                         const Settings& settings, raster::Plane<raster::Depth>& depth,
                         raster::Plane<typename Technique::Pixel>& target) {
    return draw_polygons(placed, technique, frame, settings,
                         [&](std::size_t, const auto& span, const auto& shade) {
                             return raster::draw_span(span, depth, target, shade);
                         });
}

}  // namespace scanlight::render
