#include "render/steps.h"

#include <span>

#include "raster/fill.h"
#include "render/gouraud.h"
#include "render/screen_polygons.h"
#include "render/surface_data.h"

namespace scanlight::render {

namespace {

template <int N>
PolygonSteps::Corner noted(const raster::ScreenVertex<N>& corner, std::size_t shown) {
    PolygonSteps::Corner note{static_cast<double>(corner.x) / raster::subpixels,
                              static_cast<double>(corner.y) / raster::subpixels,
                              raster::ndc_from_depth(corner.z),
                              {}};
    for (std::size_t k = 0; k < shown; ++k) {
        note.values.push_back(raster::float_from_attribute(corner.attributes[k]));
    }
    return note;
}

/// In perspective what runs along is each value times q.
std::vector<std::string> named(std::vector<std::string> names, const Settings& settings) {
    if (settings.perspective == Perspective::correct) {
        for (auto& name : names)
            name += " q";
    }
    return names;
}

/// `names` are those of the first attributes; more may run along for the perspective.
template <class Technique>
std::vector<PolygonSteps> trace_with(const PlacedMesh& placed, const Technique& technique,
                                     const Frame& frame, const Settings& settings,
                                     const std::vector<std::string>& names) {
    constexpr int N = Technique::attribute_count;
    const ScreenPolygons<Technique> polygons(placed, technique, frame, settings);
    raster::PolygonFiller<N> filler;
    std::vector<PolygonSteps> result;
    for (std::size_t face = 0; face < placed.mesh->face_count(); ++face) {
        const ScreenPolygon<N> polygon = polygons[face];
        if (polygon.fate != Fate::seen) continue;
        PolygonSteps steps{face, placed.mesh->face_id[face] + 1, names, {}, {}};
        for (const auto& corner : polygon.corners) {
            steps.corners.push_back(noted<N>(corner, names.size()));
        }
        filler.fill(
            std::span(polygon.corners), raster::Interpolation::bilinear,
            [](const raster::Span<N>&) {}, raster::Tracer<N>(steps.trace, names.size()));
        result.push_back(std::move(steps));
    }
    return result;
}

}  // namespace

std::vector<PolygonSteps> trace_polygons(const Scene& scene, const Settings& settings,
                                         raster::Viewport viewport) {
    if (scene.objects.empty()) return {};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    const PlacedMesh mesh = placed(scene.objects.front(), frame);
    switch (settings.shading) {
        case Shading::flat:
            return trace_with(mesh, IdTechnique(mesh, 1), frame, settings, {});
        case Shading::gouraud:
            return trace_with(mesh, GouraudTechnique(mesh, frame, settings), frame, settings,
                              named({"I_r", "I_g", "I_b"}, settings));
        case Shading::phong:
            return trace_with(mesh, NormalTechnique(mesh), frame, settings,
                              named({"N_x", "N_y", "N_z"}, settings));
    }
    return {};
}

}  // namespace scanlight::render
