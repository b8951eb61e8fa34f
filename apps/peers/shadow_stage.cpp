#include "apps/peers/shadow_stage.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "apps/peers/stage.h"
#include "apps/peers/surfaces.h"
#include "mesh/bounds.h"
#include "mesh/build.h"
#include "mesh/flat_shapes.h"
#include "mesh/teapot.h"
#include "mesh/triangulate.h"
#include "render/framing.h"

namespace scanlight::peers {

namespace {

mesh::Mesh triangles_of(const mesh::PolygonSoup& soup) {
    mesh::Mesh mesh = mesh::triangulated(mesh::build(soup).mesh);
    mesh.vertices.u.clear();
    mesh.vertices.v.clear();
    return mesh;
}

/// Twice as wide as the caster is long, at its lowest point.
mesh::Mesh floor_beneath(const mesh::Mesh& caster) {
    const mesh::Box box = mesh::bounding_box(caster);
    const glm::dvec3 size = box.size();
    const double half = std::max({size.x, size.y, size.z});
    mesh::PolygonSoup soup = mesh::plane(8);
    for (glm::vec3& p : soup.positions) {
        p = glm::vec3(glm::dvec3(box.center().x, box.low.y, box.center().z) + half * glm::dvec3(p));
    }
    return triangles_of(soup);
}

render::Camera camera_of(const render::Scene& scene, double aspect) {
    render::Camera camera;
    camera.eye = render::direction_of({30.0, 30.0});
    return render::with_room_for_shadows(render::framed(camera, scene.objects, aspect));
}

render::Scene scene_of(const mesh::Mesh& caster, const mesh::Mesh& floor,
                       const mesh::SilhouetteFinder& of_caster,
                       const mesh::SilhouetteFinder& of_floor, double aspect) {
    const shading::Material<float> material{
        glm::vec3(0.1f), {0.6f, 0.5f, 0.35f}, glm::vec3(0.3f), 32};
    render::Scene scene;
    scene.objects.push_back({&caster, {material}, glm::dmat4(1.0), &of_caster});
    scene.objects.push_back({&floor, {material}, glm::dmat4(1.0), &of_floor});
    scene.lighting.ambient = glm::vec3(1.0f);
    scene.lighting.lights = {
        shading::directional_light(glm::vec3(0.5f, 1.0f, 0.4f), glm::vec3(1.0f))};
    scene.camera = camera_of(scene, aspect);
    return scene;
}

std::function<mesh::Mesh()> sphere(std::uint32_t rings) {
    return [rings] { return triangles_of(displaced_sphere(rings)); };
}

}  // namespace

ShadowStage::ShadowStage(mesh::Mesh caster, raster::Viewport size)
    : caster_(std::move(caster)),
      floor_(floor_beneath(caster_)),
      silhouettes_(caster_),
      floor_silhouettes_(floor_),
      size_(size),
      scene_(scene_of(caster_, floor_, silhouettes_, floor_silhouettes_, aspect_of(size))) {}

std::vector<ShadowStagePlan> shadow_stages() {
    return {{"shadow-teapot", [] { return triangles_of(mesh::teapot(10)); }},
            {"shadow-70k", sphere(132)},
            {"shadow-100k", sphere(158)}};
}

}  // namespace scanlight::peers
