#include <algorithm>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/text_table.h"
#include "mesh/trigonometry.h"

namespace scanlight::demo {

namespace {

/// One whose centre is a pixel's centre.
constexpr raster::Viewport small{33, 33};
constexpr double most_deg = 180.0;

/// From above, a hair off the vertical, so that the camera turns with the eye.
std::string eye_text(double angle_deg) {
    const double angle = angle_deg * mesh::pi / 180.0;
    return apps::fixed(0.01 * mesh::sine(angle), 6) + ",4," +
           apps::fixed(0.01 * mesh::cosine(angle), 6);
}

std::string arguments(const std::string& interpolation, double angle_deg) {
    return "plane:1 --eye " + eye_text(angle_deg) +
           " --target 0,0,0 --fov 44 --shading gouraud --illumination lambert --ambient 0.05 "
           "--material kd=0.9 --light point:0.9,0.35,0.9,#ffd0a0 --light "
           "point:-0.9,0.35,-0.9,#a0d0ff --interpolation " +
           interpolation;
}

double centre_light(const std::string& interpolation, double angle_deg) {
    const auto picture = Stage(arguments(interpolation, angle_deg), small).framebuffer();
    return intensity(picture.color.at(small.width / 2, small.height / 2));
}

Curve centre_curve(const std::string& interpolation) {
    Curve curve{interpolation, {}};
    for (double angle = 0.0; angle <= most_deg; angle += 5.0)
        curve.points.emplace_back(angle, centre_light(interpolation, angle));
    return curve;
}

/// Neither depends on where the control stands.
const std::vector<Curve>& centre_curves() {
    static const std::vector<Curve> curves{centre_curve("bilinear"), centre_curve("triangulated")};
    return curves;
}

double range_of(const Curve& curve) {
    const auto [low, high] = std::ranges::minmax(curve.points, {}, &glm::dvec2::y);
    return high.y - low.y;
}

Panel turned_panel(const std::string& interpolation, double angle_deg, raster::Viewport size,
                   const apps::Means& means) {
    Panel panel = panel_of(interpolation, arguments(interpolation, angle_deg), size, means);
    panel.marks.push_back(mark_at({size.width / 2, size.height / 2}));
    return panel;
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const double angle = settings.at("angle");
    return {{turned_panel("bilinear", angle, size, means),
             turned_panel("triangulated", angle, size, means)},
            {{"centre-bilinear", centre_light("bilinear", angle), 3},
             {"centre-triangulated", centre_light("triangulated", angle), 3},
             {"range-bilinear", range_of(centre_curves()[0]), 3},
             {"range-triangulated", range_of(centre_curves()[1]), 3}},
            {{"centre-plot",
              {"angle-axis", 0, most_deg},
              {"light-axis", 0, 1},
              centre_curves(),
              angle}}};
}

}  // namespace

Lesson orientation_lesson() {
    return {"orientation",
            {{"angle", "φ", Slider{0, most_deg, 13, 15}}},
            {{"raster/bilinear.h", "Bilinear::along"},
             {"raster/plane.h", "Planar::of"},
             {"mesh/triangulate.h", "triangulated"}},
            draw};
}

}  // namespace scanlight::demo
