#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/settings.h"
#include "apps/demo/stage.h"
#include "raster/compare.h"
#include "render/pixel_light.h"
#include "shading/reflection.h"

namespace scanlight::demo {

namespace {

const std::vector<std::string> surfaces{"checker", "wood", "bump", "environment"};
const std::vector<std::string> mappings{"planar", "cylindrical", "spherical"};

/// The two spheres are seen from one place, so that their pixels can be counted.
const std::string place = " --eye 1.84,1.71,3.18 --target 0,0,0";

struct Body {
    std::string key;
    std::string shape;
    std::string seen = " --view 30,25";
};
const std::vector<Body> bodies{
    {"cube", "cube"}, {"cylinder", "cylinder:48"}, {"sphere", "sphere:48,24", place}};

std::string plain_arguments(const Body& body) {
    return body.shape + body.seen;
}

std::string look_of(const std::string& surface, const std::string& mapping) {
    if (surface == "checker")
        return " --texture \"diffuse=checker low=0.05 count=8 offset=0.02,0.02 mapping=" + mapping +
               "\"";
    if (surface == "wood") return " --texture \"diffuse=wood axis=y low=#40200c high=#c08040\"";
    if (surface == "bump") return " --texture \"bump=waves count=8 height=0.03 mapping=spherical\"";
    return " --environment room --material \"kd=0.05 mirror=0.8\"";
}

/// The sphere whose points are moved by as much as the bumps say.
const std::string displaced = "wavy-sphere:512,256" + place;

int covered_pixels(const raster::Plane<raster::Depth>& depth) {
    int count = 0;
    for (const raster::Depth value : depth.values())
        count += value < raster::depth_clear ? 1 : 0;
    return count;
}

/// What bumps change on the sphere: many pixels, and none of the outline.
std::vector<Number> numbers_of(const Stage& plain, const Stage& dressed) {
    const auto before = plain.framebuffer();
    const auto after = dressed.framebuffer();
    int changed = 0;
    for (int y = 0; y < before.color.height(); ++y) {
        for (int x = 0; x < before.color.width(); ++x)
            changed += before.depth.at(x, y) < raster::depth_clear &&
                               before.color.at(x, y) != after.color.at(x, y)
                           ? 1
                           : 0;
    }
    return {{"covered-plain", static_cast<double>(covered_pixels(before.depth)), 0, "px"},
            {"covered-textured", static_cast<double>(covered_pixels(after.depth)), 0, "px"},
            {"changed", static_cast<double>(changed), 0, "px"}};
}

/// What a pixel of the sphere is looked up by: its place on the texture, its distance from the axis
/// of the wood, or where it mirrors.
std::vector<Number> numbers_at(const Stage& sphere, const Pixel& pixel, raster::Viewport size) {
    const render::PixelLights lights(sphere.scene(), sphere.options().settings, size);
    const auto seen = lights.at(pixel.x, pixel.y);
    if (!seen) return {};
    if (seen->textures.empty()) {
        const glm::vec3 S = shading::reflected(seen->V, seen->N);
        return {{"s-x", S.x, 3}, {"s-y", S.y, 3}, {"s-z", S.z, 3}};
    }
    const auto& uv = seen->textures.front().uv;
    if (uv) return {{"u", uv->x, 3}, {"v", uv->y, 3}};
    return {{"radius", glm::length(glm::vec2(seen->point.x, seen->point.z)), 3}};
}

/// Beside the bumps, what they pretend.
void add_displaced(Screen& screen, raster::Viewport size, const apps::Means& means) {
    screen.panels.push_back(panel_of("displaced", displaced, size, means));
    const int covered = covered_pixels(Stage(displaced, size).framebuffer().depth);
    screen.numbers.push_back({"covered-displaced", static_cast<double>(covered), 0, "px"});
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const std::string look =
        look_of(word_of(surfaces, settings, "surface"), word_of(mappings, settings, "mapping"));
    Screen screen;
    for (const Body& body : bodies)
        screen.panels.push_back(panel_of(body.key, plain_arguments(body) + look, size, means));
    const Stage plain(plain_arguments(bodies.back()), size);
    const Stage sphere(plain_arguments(bodies.back()) + look, size);
    const Pixel pixel{size.width * 45 / 100, size.height * 40 / 100};
    screen.numbers = numbers_at(sphere, pixel, size);
    screen.panels.back().marks = {mark_at(pixel)};
    if (word_of(surfaces, settings, "surface") != "bump") return screen;
    std::ranges::copy(numbers_of(plain, sphere), std::back_inserter(screen.numbers));
    add_displaced(screen, size, means);
    return screen;
}

}  // namespace

Lesson mappings_lesson() {
    return {"mappings",
            {{"mapping", "", Choice{mappings}}, {"surface", "", Choice{surfaces}}},
            {{"shading/texture.h", "place_on"},
             {"shading/pattern.h", "wood"},
             {"shading/bump.h", "bumped_normal"},
             {"shading/environment.h", "light_from"}},
            draw};
}

}  // namespace scanlight::demo
