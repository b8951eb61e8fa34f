#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/text_table.h"

namespace scanlight::demo {

namespace {

/// Of the texture that the error is told in.
constexpr double texels = 64.0;

/// Four walls, which go away along the scanlines: of a floor all of a scanline is equally far. One
/// of them looks to 45 degrees.
std::string view_text(const std::string& perspective, const Settings& settings) {
    const std::string azimuth = apps::fixed(45.0 + settings.at("azimuth"), 0);
    return "cylinder:4 --crease 30 --fov 75 --view " + azimuth + ",0 --perspective " + perspective;
}

std::string arguments(const std::string& perspective, const Settings& settings) {
    return view_text(perspective, settings) +
           " --texture \"diffuse=checker count=8 low=0.06 repeat=4,1\" --material \"kd=#e0c8a0 "
           "ks=0\" "
           "--light 0.3,0.5,1";
}

/// Ambient light alone on a surface as bright as u: a pixel's intensity is the u that it got.
std::string parameter_arguments(const std::string& perspective, const Settings& settings) {
    return view_text(perspective, settings) +
           " --texture \"ambient=gradient low=0 high=1 repeat=4,1\" --material \"ka=1 kd=0 ks=0\" "
           "--ambient 1 "
           "--light 0,0,1,#000";
}

Curve parameter_curve(const std::string& perspective, const Settings& settings,
                      raster::Viewport size) {
    const auto picture = Stage(parameter_arguments(perspective, settings), size).framebuffer();
    const int y = size.height / 2;
    return {perspective,
            points_of(intensities(picture.color, y), surface_of_row(picture.depth, y))};
}

Curve error_curve(const Curve& affine, const Curve& correct) {
    Curve error{"error", {}};
    for (std::size_t i = 0; i < std::min(affine.points.size(), correct.points.size()); ++i) {
        error.points.emplace_back(affine.points[i].x,
                                  texels * (affine.points[i].y - correct.points[i].y));
    }
    return error;
}

double most_of(const Curve& curve) {
    double most = 0.0;
    for (const glm::dvec2& point : curve.points)
        most = std::max(most, std::abs(point.y));
    return most;
}

Panel cut_panel(const std::string& perspective, const Settings& settings, raster::Viewport size,
                const apps::Means& means) {
    Panel panel = panel_of(perspective, arguments(perspective, settings), size, means);
    panel.marks.push_back(mark_along(size.height / 2, size.width));
    return panel;
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const Curve affine = parameter_curve("affine", settings, size);
    const Curve correct = parameter_curve("correct", settings, size);
    const Curve error = error_curve(affine, correct);
    const Axis pixels{"pixel-axis", 0, static_cast<double>(size.width)};
    return {
        {cut_panel("affine", settings, size, means), cut_panel("correct", settings, size, means)},
        {{"worst-texels", most_of(error), 2}},
        {{"parameter-plot", pixels, {"u-axis", 0, 1}, {affine, correct}},
         {"error-plot", pixels, {"texel-axis", -24, 24}, {error}}}};
}

}  // namespace

Lesson perspective_lesson() {
    return {"perspective",
            {{"azimuth", "", Slider{0, 45, 6, 27}}},
            {{"raster/project.h", "project_affine"}, {"raster/project.h", "project_correct"}},
            draw};
}

}  // namespace scanlight::demo
