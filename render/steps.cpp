#include "render/steps.h"

#include <span>

#include "raster/fill.h"
#include "render/gouraud.h"
#include "render/screen_polygons.h"
#include "render/surface_data.h"

namespace scanlight::render {

namespace {

/// The first `count` of the numbers: a constant that runs along for the perspective is not shown.
template <std::size_t N>
std::vector<double> shown(const std::array<double, N>& numbers, std::size_t count) {
    std::vector<double> result;
    for (std::size_t k = 0; k < count; ++k)
        result.push_back(numbers[k]);
    return result;
}

template <int N>
class StepsWriter {
public:
    StepsWriter(std::vector<std::string> names, std::size_t corners)
        : names_(std::move(names)), corner_count_(static_cast<std::uint32_t>(corners)) {}

    PolygonSteps written(const std::vector<raster::ScreenVertex<N>>& corners,
                         const raster::Trace<N>& trace) const {
        PolygonSteps steps;
        steps.names = names_;
        for (const auto& corner : corners)
            steps.corners.push_back(written(corner));
        for (const auto& edge : trace.edge_table)
            steps.edge_table.push_back(written(edge));
        for (const auto& line : trace.scanlines)
            steps.scanlines.push_back(written(line));
        return steps;
    }

private:
    PolygonSteps::Corner written(const raster::ScreenVertex<N>& corner) const {
        std::vector<double> values;
        for (std::size_t k = 0; k < names_.size(); ++k) {
            values.push_back(raster::float_from_attribute(corner.attributes[k]));
        }
        return {static_cast<double>(corner.x) / raster::subpixels,
                static_cast<double>(corner.y) / raster::subpixels, raster::ndc_from_depth(corner.z),
                values};
    }

    PolygonSteps::Edge written(const typename raster::Trace<N>::Edge& edge) const {
        return {edge.index,
                (edge.index + 1) % corner_count_,
                edge.y_begin,
                edge.y_end,
                edge.x,
                edge.dx,
                edge.z,
                edge.dz,
                shown(edge.values, names_.size()),
                shown(edge.steps, names_.size())};
    }

    PolygonSteps::Scanline written(const typename raster::Trace<N>::Scanline& line) const {
        PolygonSteps::Scanline result{line.y, {}, {}};
        for (const auto& edge : line.active)
            result.active.push_back(written(edge));
        for (const auto& span : line.spans) {
            result.spans.push_back({span.x_begin, span.x_end, span.z, span.dz,
                                    shown(span.values, names_.size()),
                                    shown(span.steps, names_.size())});
        }
        return result;
    }

    std::vector<std::string> names_;
    std::uint32_t corner_count_;
};

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
        raster::Trace<N> trace;
        filler.fill(
            std::span(polygon.corners), raster::Interpolation::bilinear,
            [](const raster::Span<N>&) {}, raster::Tracer<N>(trace));
        const StepsWriter<N> writer(names, polygon.corners.size());
        result.push_back(writer.written(polygon.corners, trace));
        result.back().face = face;
        result.back().id = placed.mesh->face_id[face] + 1;
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
                              {"I_r", "I_g", "I_b"});
        case Shading::phong:
            return trace_with(mesh, NormalTechnique(mesh), frame, settings, {"N_x", "N_y", "N_z"});
    }
    return {};
}

}  // namespace scanlight::render
