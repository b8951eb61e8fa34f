#include "render/cube_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "render/framing.h"
#include "render/light_view.h"
#include "render/renderer.h"
#include "render/textured.h"

namespace scanlight::render {

namespace {

Scene without_what_shows_environments(Scene scene) {
    std::erase_if(scene.objects, [](const Object& object) {
        return std::ranges::any_of(object.materials, shows_environment);
    });
    return scene;
}

/// The pixel of a square picture that shows a place in [-1, 1], y upwards.
const raster::Rgba& pixel_at(const raster::Plane<raster::Rgba>& picture, const glm::dvec3& place) {
    const auto pixel = [&](double x) {
        return std::clamp(static_cast<int>(std::floor(0.5 * (1.0 + x) * picture.width())), 0,
                          picture.width() - 1);
    };
    return picture.at(pixel(place.x), pixel(-place.y));
}

/// A face's texels, from the picture of a camera that looks at its middle.
std::shared_ptr<const shading::TexelImage> face_image(int face, const Camera& camera,
                                                      const raster::Plane<raster::Rgba>& picture) {
    const LightView view(camera);
    const int side = picture.width();
    std::vector<float> rgba;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const auto d = shading::direction_on_cube(face, (i + 0.5) / side, (j + 0.5) / side);
            const raster::Rgba& color = pixel_at(picture, view.seen(camera.eye + d));
            rgba.insert(rgba.end(), {color.r, color.g, color.b, 1.0f});
        }
    }
    return std::make_shared<const shading::TexelImage>(side, side, rgba);
}

}  // namespace

shading::Environment cube_map(const Scene& scene, Settings settings, const glm::dvec3& point,
                              int side) {
    Scene seen = without_what_shows_environments(scene);
    settings.grid = 1;
    Renderer renderer;
    shading::Environment environment{shading::EnvironmentLayout::cube, {}, glm::mat3(1.0f)};
    const auto cameras = light_cameras(glm::dvec4(point, 1.0), seen.objects);
    for (std::size_t face = 0; face < cameras.size(); ++face) {
        seen.camera =
            counts_volumes(settings.shadows) ? with_room_for_shadows(cameras[face]) : cameras[face];
        raster::Plane<raster::Rgba> picture({side, side}, seen.background);
        renderer.draw(seen, settings, picture);
        environment.images[face] = face_image(static_cast<int>(face), seen.camera, picture);
    }
    return environment;
}

}  // namespace scanlight::render
