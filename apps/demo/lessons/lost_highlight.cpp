#include <algorithm>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/text_table.h"
#include "mesh/trigonometry.h"
#include "raster/compare.h"

namespace scanlight::demo {

namespace {

constexpr int most_levels = 5;

std::string light_text(double azimuth_deg) {
    const double angle = azimuth_deg * mesh::pi / 180.0;
    return apps::fixed(mesh::sine(angle), 4) + ",0.4," + apps::fixed(mesh::cosine(angle), 4);
}

std::string arguments(const std::string& shading, int level, const Settings& settings) {
    return "icosphere:" + std::to_string(level) +
           " --eye 0,0,4 --target 0,0,0 --fov 32 --material \"kd=#305090 ks=0.8 n=" +
           apps::fixed(settings.at("n"), 0) + "\" --light " + light_text(settings.at("light")) +
           " --shading " + shading;
}

raster::Difference difference(const Panel& gouraud, const Panel& phong) {
    return raster::compare(gouraud.picture, phong.picture);
}

double worst_of(const raster::Difference& found) {
    return found.worst ? std::abs(found.worst->first - found.worst->second) : 0.0;
}

/// At each level of subdivision, how far Gouraud's picture is from Phong's.
std::vector<glm::dvec2> error_curve(const Settings& settings, raster::Viewport size,
                                    const apps::Means& means) {
    std::vector<glm::dvec2> points;
    for (int level = 0; level <= most_levels; ++level) {
        const Panel gouraud = panel_of("", arguments("gouraud", level, settings), size, means);
        const Panel phong = panel_of("", arguments("phong", level, settings), size, means);
        points.emplace_back(level, worst_of(difference(gouraud, phong)));
    }
    return points;
}

double brightest_light(const std::string& arguments, raster::Viewport size) {
    const raster::Framebuffer picture = Stage(arguments, size).framebuffer();
    const Pixel pixel = brightest(picture);
    return intensity(picture.color.at(pixel.x, pixel.y));
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const int level = static_cast<int>(settings.at("level"));
    const std::string by_gouraud = arguments("gouraud", level, settings);
    const std::string by_phong = arguments("phong", level, settings);
    const Panel gouraud = panel_of("gouraud", by_gouraud, size, means);
    const Panel phong = panel_of("phong", by_phong, size, means);
    const raster::Difference found = difference(gouraud, phong);
    return {{gouraud, phong, difference_panel(gouraud, phong)},
            {{"triangles", static_cast<double>(20 << (2 * level))},
             {"mean-error", found.mean_absolute, 2},
             {"worst-error", worst_of(found)},
             {"peak-gouraud", brightest_light(by_gouraud, size), 3},
             {"peak-phong", brightest_light(by_phong, size), 3}},
            {{"error-plot",
              {"level-axis", 0, most_levels},
              {"error-axis", 0, 255},
              {{"worst-error", error_curve(settings, size, means)}},
              level}}};
}

}  // namespace

Lesson lost_highlight_lesson() {
    return {"lost-highlight",
            {{"level", "", Slider{0, most_levels, most_levels + 1, 1}},
             {"n", "n", Slider{10, 90, 3, 50}},
             {"light", "", Slider{-20, 20, 3, -20}}},
            {{"render/gouraud.h", "GouraudTechnique"},
             {"render/phong.h", "PhongTechnique"},
             {"shading/phong.h", "phong"}},
            draw};
}

}  // namespace scanlight::demo
