#include <algorithm>
#include <cmath>

#include "apps/exercises/exercise.h"
#include "apps/scanlight/picture.h"
#include "apps/scene/parse.h"
#include "apps/scene/scene_setup.h"
#include "raster/srgb.h"
#include "render/draw.h"

#include <your_part.h>  // of the folder that the build names

namespace scanlight::exercises {

namespace {

constexpr Surface surface{0.3, 0.5, 0.4, 20.0};
constexpr Light light{0.2, 1.0};

/// Eye and light are far away, so that V and L are the same everywhere.
apps::SceneOptions options() {
    auto options = apps::parse_scene(
        "teapot:6 --projection orthographic --distances infinite --sides two --background 0 "
        "--view 20,25 --light world:-1,2,2 --ambient 0.2 --material \"ka=0.3 kd=0.5 ks=0.4 "
        "n=20\"");
    options.size = {160, 120};
    return options;
}

raster::Image8 right() {
    const auto chosen = options();
    const auto models = apps::load_models(chosen);
    const auto picture = apps::draw_picture(apps::scene_of(models, chosen), chosen, {}, {});
    return apps::byte_image(picture, raster::Alpha::dropped);
}

raster::Image8 yours() {
    const auto chosen = options();
    const auto models = apps::load_models(chosen);
    const render::Scene scene = apps::scene_of(models, chosen);
    const auto normals = render::draw_normals(scene, chosen.settings, chosen.size);
    const glm::dvec3 V = glm::normalize(scene.camera.eye - scene.camera.target);
    const glm::dvec3 L = glm::normalize(glm::dvec3(-1, 2, 2));
    raster::Image8 image(chosen.size.width, chosen.size.height, 3);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const glm::dvec3 N(normals.at(x, y));
            if (N == glm::dvec3(0.0)) continue;
            const double I = intensity(N, L, V, surface, light);
            std::ranges::fill(image.pixel(x, y), raster::srgb_from_linear(static_cast<float>(I)));
        }
    }
    return image;
}

Checks checks() {
    Checks checks;
    const glm::dvec3 N(0, 0, 1);
    const glm::dvec3 slanting(0.6, 0, 0.8);
    checks.number("all three along the normal", intensity(N, N, N, surface, light), 0.06 + 0.9);
    checks.number("the light slanting, the viewer along the normal",
                  intensity(N, slanting, N, surface, light), 0.06 + 0.4 + 0.4 * std::pow(0.8, 20));
    checks.number("the viewer where the light is mirrored to",
                  intensity(N, slanting, {-0.6, 0, 0.8}, surface, light), 0.06 + 0.4 + 0.4);
    checks.number("the light behind the surface", intensity(N, -slanting, N, surface, light), 0.06);
    checks.number("the viewer where no mirrored light goes",
                  intensity(N, slanting, {1, 0, 0}, surface, light), 0.06 + 0.4);
    return checks;
}

}  // namespace

}  // namespace scanlight::exercises

int main(int argc, char** argv) {
    using namespace scanlight::exercises;
    return judge({"phong", checks, yours, right, 1}, argc, argv);
}
