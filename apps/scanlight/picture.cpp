#include "apps/scanlight/picture.h"

#include <algorithm>
#include <cmath>

#include "raster/image_of.h"
#include "render/wireframe.h"

namespace scanlight::apps {

namespace {

constexpr raster::Rgba line_color{0.01f, 0.012f, 0.018f, 1.0f};

/// Everything drawn so far painted over with the background: only its depth remains.
void keep_depth_only(raster::Framebuffer& target, raster::Rgba background) {
    target.color = raster::Plane<raster::Rgba>(target.size(), background);
}

}  // namespace

render::Drawing draw_picture(const render::Scene& scene, const SceneOptions& options) {
    render::Drawing drawing = render::draw(scene, options.settings, options.size);
    const Wireframe wireframe = wireframe_of(options);
    if (wireframe == Wireframe::none) return drawing;
    if (wireframe != Wireframe::over) keep_depth_only(drawing.framebuffer, scene.background);
    render::draw_wireframe(
        scene, line_color,
        wireframe == Wireframe::all ? render::HiddenLines::shown : render::HiddenLines::removed,
        drawing.framebuffer);
    return drawing;
}

raster::Image8 normals_image(const raster::Plane<glm::vec3>& normals) {
    return raster::image_of<std::uint8_t>(normals, 3, [](auto pixel, const glm::vec3& n) {
        if (n == glm::vec3(0.0f)) return;
        for (int k = 0; k < 3; ++k) {
            pixel[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(
                std::lrint(std::clamp(n[k] * 0.5f + 0.5f, 0.0f, 1.0f) * 255.0f));
        }
    });
}

raster::ImageF normals_float_image(const raster::Plane<glm::vec3>& normals) {
    return raster::image_of<float>(normals, 3, [](auto pixel, const glm::vec3& n) {
        for (int k = 0; k < 3; ++k)
            pixel[static_cast<std::size_t>(k)] = n[k];
    });
}

raster::Image8 ids_image(const raster::Plane<std::uint32_t>& ids) {
    return raster::image_of<std::uint8_t>(ids, 3, [](auto pixel, std::uint32_t id) {
        pixel[0] = static_cast<std::uint8_t>(id >> 16);
        pixel[1] = static_cast<std::uint8_t>(id >> 8);
        pixel[2] = static_cast<std::uint8_t>(id);
    });
}

raster::ImageF ids_float_image(const raster::Plane<std::uint32_t>& ids) {
    return raster::image_of<float>(
        ids, 1, [](auto pixel, std::uint32_t id) { pixel[0] = static_cast<float>(id); });
}

raster::ImageF float_image(const raster::Plane<float>& values) {
    return raster::image_of<float>(values, 1, [](auto pixel, float value) { pixel[0] = value; });
}

}  // namespace scanlight::apps
