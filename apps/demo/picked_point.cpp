#include "apps/demo/picked_point.h"

#include <tuple>

#include "render/draw.h"
#include "render/frame.h"
#include "shading/blinn.h"
#include "shading/light.h"
#include "shading/reflection.h"

namespace scanlight::demo {

PickedPoint picked_point(const Stage& stage, const Pixel& wanted) {
    const auto& [settings, size] = std::tie(stage.options().settings, stage.options().size);
    const render::Scene& scene = stage.scene();
    const render::Frame frame = render::frame_of(scene, settings.distances, size);
    const auto depth = render::draw_depth(scene, settings, size).framebuffer.depth;
    const Pixel pixel = nearest_surface(depth, wanted);
    const auto normals = render::draw_normals(scene, settings, size);
    const glm::vec3 point = frame.point_at(pixel.x, pixel.y, depth.at(pixel.x, pixel.y));
    const shading::Vec3<double> N(normals.at(pixel.x, pixel.y));
    const shading::Vec3<double> L(
        shading::incident_at(frame.lighting.lights.front(), point).direction);
    const shading::Vec3<double> V(frame.view_at(pixel.x, pixel.y));
    return {pixel, {N, L, V, shading::half_vector(L, V), shading::reflected(L, N)}};
}

}  // namespace scanlight::demo
