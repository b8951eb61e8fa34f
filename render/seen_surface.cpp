#include "render/seen_surface.h"

#include <span>

#include "raster/fill.h"
#include "raster/fragments.h"
#include "render/screen_polygons.h"
#include "render/technique.h"

namespace scanlight::render {

namespace {

/// The span stepped on to a column, as the walk does it.
template <int N>
raster::Fragment<N> fragment_of(raster::Span<N> span, int column) {
    for (int x = span.x_begin; x < column; ++x)
        span.ramps.step();
    return raster::fragment_at<N>(column, span.y, span.ramps.depth.get(), span.ramps);
}

template <int N>
TexturedSurface<float> surface_by(const TexturedPhongTechnique<N>& technique,
                                  const PlacedMesh& mesh, std::size_t face, const Frame& frame,
                                  const Settings& settings, const glm::ivec2& pixel) {
    const ScreenPolygons polygons(mesh, technique, frame, settings);
    const ScreenPolygon<N> polygon = polygons[face];
    const auto common = technique.polygon(face, polygon.side);
    TexturedSurface<float> surface{};
    raster::PolygonFiller<N> filler;
    filler.fill(std::span(polygon.corners), raster::Interpolation::planar,
                [&](const raster::Span<N>& span) {
                    if (span.y == pixel.y && span.x_begin <= pixel.x && pixel.x < span.x_end)
                        surface = technique.surface(fragment_of(span, pixel.x), common);
                });
    return surface;
}

}  // namespace

TexturedSurface<float> seen_surface(const PlacedMesh& mesh, std::size_t face, const Frame& frame,
                                    const Settings& settings, const glm::ivec2& pixel) {
    return with_attribute_count(textured_attributes(*mesh.object).count(), [&](auto n) {
        return surface_by(TexturedPhongTechnique<n>(mesh, frame, settings), mesh, face, frame,
                          settings, pixel);
    });
}

}  // namespace scanlight::render
