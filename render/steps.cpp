#include "render/steps.h"

#include <algorithm>
#include <span>
#include <utility>

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

/// Values that ran along in multiples of `unit`, as they are.
PolygonSteps multiplied(PolygonSteps steps, double unit) {
    const auto multiply = [unit](std::vector<double>& values) {
        for (double& value : values)
            value *= unit;
    };
    const auto multiply_both = [&](raster::Trace::Numbers& numbers) {
        multiply(numbers.values);
        multiply(numbers.steps);
    };
    for (auto& corner : steps.corners)
        multiply(corner.values);
    std::ranges::for_each(steps.trace.edge_table, multiply_both);
    for (auto& line : steps.trace.scanlines) {
        std::ranges::for_each(line.active, multiply_both);
        std::ranges::for_each(line.spans, multiply_both);
    }
    return steps;
}

/// `names` are those of the first attributes; more may run along for the perspective.
template <class Technique>
std::vector<PolygonSteps> trace_with(const ScreenPolygons<Technique>& polygons,
                                     const std::vector<SeenPolygon>& chosen,
                                     const std::vector<std::string>& names, double unit = 1.0) {
    constexpr int N = Technique::attribute_count;
    raster::PolygonFiller<N> filler;
    std::vector<PolygonSteps> result;
    for (const auto& [face, id, scanlines] : chosen) {
        const ScreenPolygon<N> polygon = polygons[face];
        PolygonSteps steps{face, id, names, {}, {}};
        for (const auto& corner : polygon.corners) {
            steps.corners.push_back(noted<N>(corner, names.size()));
        }
        filler.fill(
            std::span(polygon.corners), raster::Interpolation::bilinear,
            [](const raster::Span<N>&) {}, raster::Tracer<N>(steps.trace, names.size()));
        result.push_back(multiplied(std::move(steps), unit));
    }
    return result;
}

int scanlines_of(const std::vector<raster::ScreenVertex<0>>& corners) {
    const auto [top, bottom] =
        std::ranges::minmax_element(corners, {}, &raster::ScreenVertex<0>::y);
    return raster::first_centre(bottom->y) - raster::first_centre(top->y);
}

}  // namespace

std::vector<SeenPolygon> seen_polygons(const Scene& scene, const Settings& picture,
                                       raster::Viewport viewport) {
    if (scene.objects.empty()) return {};
    const Settings settings = settings_of(scene.objects.front(), picture);
    const Frame frame = frame_of(scene, settings.distances, viewport);
    const PlacedMesh mesh = placed(scene.objects.front(), frame);
    const IdTechnique ids(mesh, 1);
    const ScreenPolygons<IdTechnique> polygons(mesh, ids, frame, settings);
    std::vector<SeenPolygon> result;
    for (std::size_t face = 0; face < mesh.mesh->face_count(); ++face) {
        const ScreenPolygon<0> polygon = polygons[face];
        if (polygon.fate != Fate::seen) continue;
        result.push_back({face, ids.polygon(face, polygon.side), scanlines_of(polygon.corners)});
    }
    return result;
}

std::vector<PolygonSteps> trace_polygons(const Scene& scene, const Settings& picture,
                                         raster::Viewport viewport,
                                         const std::vector<SeenPolygon>& polygons) {
    if (polygons.empty()) return {};
    const Settings settings = settings_of(scene.objects.front(), picture);
    const Frame frame = frame_of(scene, settings.distances, viewport);
    const PlacedMesh mesh = placed(scene.objects.front(), frame);
    const auto trace = [&](const auto& technique, const std::vector<std::string>& names,
                           double unit = 1.0) {
        const ScreenPolygons on_screen(mesh, technique, frame, settings);
        return trace_with(on_screen, polygons, named(names, settings), unit);
    };
    switch (settings.shading) {
        case Shading::flat:
            return trace(IdTechnique(mesh, 1), {});
        case Shading::gouraud: {
            const GouraudTechnique technique(mesh, frame, settings);
            return trace(technique, {"I_r", "I_g", "I_b"}, technique.unit());
        }
        case Shading::phong:
            return trace(NormalTechnique(mesh), {"N_x", "N_y", "N_z"});
    }
    return {};
}

std::vector<PolygonSteps> trace_polygons(const Scene& scene, const Settings& settings,
                                         raster::Viewport viewport) {
    return trace_polygons(scene, settings, viewport, seen_polygons(scene, settings, viewport));
}

}  // namespace scanlight::render
