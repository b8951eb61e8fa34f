#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "apps/demo/embedded.h"
#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/text_table.h"
#include "apps/scene/read_scene.h"
#include "shading/blending.h"

namespace scanlight::demo {

namespace {

using shading::Rgb;

const std::string scene_path = "apps/demo/scenes/panes.toml";
const std::array<std::string, 3> panes{"red-pane", "green-pane", "blue-pane"};  // front to back

apps::SceneOptions scene_options(double opacity) {
    apps::SceneOptions options;
    options.input = scene_path;
    apps::read_scene(options, embedded::panes, scene_path, "");
    options.material.opacity = static_cast<float>(opacity);
    return options;
}

std::string material_text(double opacity) {
    return " --material opacity=" + apps::fixed(opacity, 2);
}

Panel seen_from(const std::string& key, double z, double opacity, raster::Viewport size,
                const apps::Means& means) {
    apps::SceneOptions options = scene_options(opacity);
    options.eye = glm::dvec3(0.0, 0.0, z);
    options.target = glm::dvec3(0.0);
    const std::string eye = " --eye 0,0," + apps::fixed(z, 0) + " --target 0,0,0";
    Panel panel = Stage(scene_path + eye + material_text(opacity), options, size).panel(key, means);
    panel.marks = {mark_at({size.width / 2, size.height / 2})};
    return panel;
}

/// At the middle of the picture.
Rgb<double> middle_of(const apps::SceneOptions& options, raster::Viewport size) {
    const auto picture = Stage("", options, size).framebuffer();
    return Rgb<double>(picture.color.at(size.width / 2, size.height / 2));
}

/// A pane's own light: alone, and opaque.
Rgb<double> light_of_pane(std::size_t pane, raster::Viewport size) {
    apps::SceneOptions options = scene_options(1.0);
    options.objects = {options.objects[pane]};
    return middle_of(options, size);
}

Rgb<double> background(raster::Viewport size) {
    apps::SceneOptions options = scene_options(0.0);
    return middle_of(options, size);
}

std::string color_text(const Rgb<double>& color) {
    return apps::fixed(color.r, 3) + ", " + apps::fixed(color.g, 3) + ", " +
           apps::fixed(color.b, 3);
}

/// What a layer behind all others would keep of its light.
double let_through(const shading::Layers<double>& layers) {
    const shading::Layers<double> unlit{Rgb<double>(0.0), layers.transparency};
    return shading::before(unlit, Rgb<double>(1.0)).r;
}

/// The panes in an order, the nearest first, and what each adds to what is seen.
struct Blending {
    Table table;
    Rgb<double> seen;
};

Blending blended(const std::string& key, const std::array<std::size_t, 3>& order, double opacity,
                 raster::Viewport size) {
    Blending result{{key, {"{{pane}}", "I", "{{shows-through}}", "{{share}}"}, {}}, {}};
    shading::Layers<double> layers;
    for (const std::size_t pane : order) {
        const Rgb<double> light = light_of_pane(pane, size);
        const double through = let_through(layers);
        result.table.rows.push_back({"{{" + panes[pane] + "}}", color_text(light),
                                     apps::fixed(through, 3), apps::fixed(through * opacity, 3)});
        layers = shading::with_pane_behind(layers, light, opacity);
    }
    result.seen = shading::before(layers, background(size));
    result.table.rows.push_back({"{{background}}", color_text(background(size)),
                                 apps::fixed(let_through(layers), 3),
                                 apps::fixed(let_through(layers), 3)});
    result.table.rows.push_back({"{{seen}}", color_text(result.seen), "", ""});
    return result;
}

double most_apart(const Rgb<double>& a, const Rgb<double>& b) {
    const Rgb<double> apart = glm::abs(a - b);
    return std::max({apart.r, apart.g, apart.b});
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const double opacity = settings.at("opacity");
    const Blending front = blended("front-order", {0, 1, 2}, opacity, size);
    const Blending back = blended("back-order", {2, 1, 0}, opacity, size);
    return {
        {seen_from("from-front", 6.0, opacity, size, means),
         seen_from("from-back", -6.0, opacity, size, means)},
        {{"order-difference", most_apart(front.seen, back.seen), 3},
         {"engine-difference", most_apart(front.seen, middle_of(scene_options(opacity), size)), 5}},
        {},
        {front.table, back.table}};
}

}  // namespace

Lesson transparency_lesson() {
    return {"transparency",
            {{"opacity", "1−t", Slider{0.1, 0.9, 9, 0.6, 2}}},
            {{"shading/blending.h", "with_pane_behind"}, {"render/layers.h", "Blend"}},
            draw,
            {{scene_path, embedded::panes}}};
}

}  // namespace scanlight::demo
