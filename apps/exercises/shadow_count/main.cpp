#include <algorithm>
#include <cstdlib>

#include "apps/exercises/exercise.h"
#include "apps/scanlight/picture.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/scene_setup.h"
#include "render/draw.h"
#include "render/shadows.h"

#include <your_part.h>  // of the folder that the build names

namespace scanlight::exercises {

namespace {

/// The eye stands in the torus' shadow.
apps::SceneOptions options() {
    auto options = apps::parse_scene(
        "torus:10,6 --floor --shadows zfail --light point:0,1.6,-2.5 --eye 0.6,-0.2,1.7 "
        "--target 0,0,0 --fov 75");
    options.size = {64, 48};
    return options;
}

/// A face may stand for several volumes that are entered or left at once. Of the volumes that the
/// ray begins in nobody tells.
std::vector<Crossing> crossings_of(const std::vector<render::ShadowCrossing>& met,
                                   raster::Depth surface) {
    std::vector<Crossing> crossings;
    for (const auto& crossing : met) {
        if (crossing.part == render::VolumePart::near_cut) continue;
        const Crossing one{crossing.entered > 0, crossing.depth >= surface};
        crossings.insert(crossings.end(), static_cast<std::size_t>(std::abs(crossing.entered)),
                         one);
    }
    return crossings;
}

/// Dark where `is_in_shadow(x, y, depth)`, bright elsewhere, black where nothing is.
template <class IsInShadow>
raster::Image8 picture(const render::Scene& scene, const apps::SceneOptions& chosen,
                       IsInShadow&& is_in_shadow) {
    const auto drawing = render::draw_depth(scene, chosen.settings, chosen.size);
    raster::Image8 image(chosen.size.width, chosen.size.height, 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const raster::Depth depth = drawing.framebuffer.depth.at(x, y);
            if (depth == raster::depth_clear) continue;
            image.pixel(x, y)[0] = is_in_shadow(x, y, depth) ? 90 : 230;
        }
    }
    return image;
}

raster::Image8 yours() {
    const auto chosen = options();
    const auto models = apps::load_models(chosen);
    const render::Scene scene = apps::scene_of(models, chosen);
    return picture(scene, chosen, [&](int x, int y, raster::Depth depth) {
        return is_in_shadow(crossings_of(
            render::shadow_crossings(scene, chosen.settings, 0, chosen.size, x, y), depth));
    });
}

raster::Image8 right() {
    const auto chosen = options();
    const auto models = apps::load_models(chosen);
    const render::Scene scene = apps::scene_of(models, chosen);
    const auto counts = apps::draw_stencil(scene, chosen);
    return picture(scene, chosen,
                   [&](int x, int y, raster::Depth) { return counts.at(x, y) != 0; });
}

Checks checks() {
    Checks checks;
    const Crossing entered_before{true, false};
    const Crossing left_before{false, false};
    const Crossing entered_behind{true, true};
    const Crossing left_behind{false, true};
    checks.answer("in shadow where there is no volume", is_in_shadow({}), false);
    checks.answer("in shadow inside one volume", is_in_shadow({entered_before, left_behind}), true);
    checks.answer("in shadow behind a volume", is_in_shadow({entered_before, left_before}), false);
    checks.answer("in shadow before a volume", is_in_shadow({entered_behind, left_behind}), false);
    checks.answer("in shadow between two volumes",
                  is_in_shadow({entered_before, left_before, entered_behind, left_behind}), false);
    checks.answer("in shadow inside both of two volumes",
                  is_in_shadow({entered_before, entered_before, left_behind, left_behind}), true);
    checks.answer("in shadow when the eye is, and the surface is in the same one",
                  is_in_shadow({left_behind}), true);
    checks.answer("in shadow when the eye is and the surface is not", is_in_shadow({left_before}),
                  false);
    return checks;
}

}  // namespace

}  // namespace scanlight::exercises

int main(int argc, char** argv) {
    using namespace scanlight::exercises;
    return judge({"shadow_count", checks, yours, right}, argc, argv);
}
