#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "mesh/trigonometry.h"
#include "raster/compare.h"

namespace scanlight::demo {

namespace {

constexpr int stacks = 24;
constexpr int fine = 360;
constexpr int coarsest = 6;
constexpr int finest = 48;

/// From above the pole and in parallel, the outline is the equator's polygon.
std::string arguments(int slices) {
    return "sphere:" + std::to_string(slices) + "," + std::to_string(stacks) +
           " --projection orthographic --eye 0,4,0 --target 0,0,0 --fov 32 --crease 180";
}

raster::Plane<raster::Depth> depth_of(int slices, raster::Viewport size) {
    return Stage(arguments(slices), size).framebuffer().depth;
}

double distance_from_centre(int x, int y, raster::Viewport size) {
    return std::hypot(x + 0.5 - 0.5 * size.width, y + 0.5 - 0.5 * size.height);
}

/// What lies in the round outline and not in the polygon's.
struct Missing {
    int pixels = 0;
    double depth = 0.0;  // the deepest notch, from the round outline inwards, in pixels
};

Missing missing(const raster::Plane<raster::Depth>& coarse,
                const raster::Plane<raster::Depth>& round) {
    const raster::Viewport size{round.width(), round.height()};
    Missing found;
    double radius = 0.0;
    double least = 1e9;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (round.at(x, y) >= raster::depth_clear) continue;
            const double r = distance_from_centre(x, y, size);
            radius = std::max(radius, r);
            if (coarse.at(x, y) < raster::depth_clear) continue;
            ++found.pixels;
            least = std::min(least, r);
        }
    }
    found.depth = found.pixels == 0 ? 0.0 : radius - least;
    return found;
}

double radius_of(const raster::Plane<raster::Depth>& round) {
    const int y = round.height() / 2;
    const Stretch stretch = surface_of_row(round, y);
    return 0.5 * (stretch.end - stretch.begin);
}

/// How far a chord's middle is from its circle.
double sagitta(double radius, int sides) {
    return radius * (1.0 - mesh::cosine(mesh::pi / sides));
}

Plot gap_plot(const raster::Plane<raster::Depth>& round, raster::Viewport size, int slices) {
    Curve measured{"measured", {}};
    Curve formula{"formula", {}};
    for (int n = coarsest; n <= finest; n += 3) {
        measured.points.emplace_back(n, missing(depth_of(n, size), round).depth);
        formula.points.emplace_back(n, sagitta(radius_of(round), n));
    }
    return {"gap-plot",
            {"slices-axis", coarsest, finest},
            {"gap-axis", 0, 16},
            {measured, formula},
            static_cast<double>(slices)};
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const int slices = static_cast<int>(settings.at("slices"));
    const auto round = depth_of(fine, size);
    const Missing found = missing(depth_of(slices, size), round);
    const Panel coarse = panel_of("polygon", arguments(slices), size, means);
    const Panel circle = panel_of("circle", arguments(fine), size, means);
    return {{coarse, circle, difference_panel(coarse, circle)},
            {{"polygons", static_cast<double>(slices * stacks)},
             {"gap", found.depth, 1, "px"},
             {"sagitta", sagitta(radius_of(round), slices), 1, "px"},
             {"missing", static_cast<double>(found.pixels), 0, "px"}},
            {gap_plot(round, size, slices)}};
}

}  // namespace

Lesson silhouette_lesson() {
    return {"silhouette",
            {{"slices", "n", Slider{coarsest, finest, 8, 12}}},
            {{"render/phong.h", "PhongTechnique"}, {"mesh/round_shapes.h", "uv_sphere"}},
            draw};
}

}  // namespace scanlight::demo
