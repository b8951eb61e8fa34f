#include "render/draw.h"

#include "render/flat.h"
#include "render/gouraud.h"
#include "render/phong.h"
#include "render/shadows.h"
#include "render/surface_data.h"
#include "render/textured_phong.h"

namespace scanlight::render {

namespace {

/// Calls `use` with the number as a constant.
template <class Use>
decltype(auto) with_attribute_count(int count, Use&& use) {
    switch (count) {
        case 6:
            return use(std::integral_constant<int, 6>{});
        case 7:
            return use(std::integral_constant<int, 7>{});
        case 9:
            return use(std::integral_constant<int, 9>{});
        default:
            return use(std::integral_constant<int, 3>{});
    }
}

/// Techniques are chosen here, once an object, and nowhere further in. Calls `use` with it.
template <class Use>
decltype(auto) with_technique(const PlacedMesh& placed, const Frame& frame,
                              const Settings& settings, Use&& use) {
    if (settings.shading == Shading::gouraud) {
        return use(GouraudTechnique(placed, frame, settings));
    }
    if (settings.shading == Shading::phong && is_textured(*placed.object)) {
        return with_model(settings, [&](auto model) {
            return with_attribute_count(textured_attributes(*placed.object).count(), [&](auto n) {
                return use(TexturedPhongTechnique<decltype(model), n>(placed, frame, model));
            });
        });
    }
    return with_model(settings, [&](auto model) {
        return with_paint(*placed.mesh, [&](auto paint) {
            if (settings.shading == Shading::flat) {
                return use(FlatTechnique<decltype(model), paint>(placed, frame, model));
            }
            return use(PhongTechnique<decltype(model), paint>(placed, frame, model));
        });
    });
}

DrawCounts draw_object(const PlacedMesh& placed, const Frame& frame, const Settings& settings,
                       raster::Framebuffer& target) {
    return with_technique(placed, frame, settings, [&](const auto& technique) {
        return draw_polygons(placed, technique, frame, settings, target.depth, target.color);
    });
}

}  // namespace

DrawCounts& DrawCounts::operator+=(const DrawCounts& other) {
    polygons += other.polygons;
    outside += other.outside;
    culled += other.culled;
    drawn += other.drawn;
    spans += other.spans;
    pixels_tested += other.pixels_tested;
    pixels_passed += other.pixels_passed;
    pixels_shaded += other.pixels_shaded;
    return *this;
}

Drawing draw(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    if (settings.shadows != Shadows::none) return draw_with_shadows(scene, settings, viewport);
    Drawing result{raster::Framebuffer(viewport, scene.background), {}};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    for (const Object& object : scene.objects) {
        result.counts += draw_object(placed(object, frame), frame, settings, result.framebuffer);
    }
    return result;
}

Drawing draw_depth(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    Drawing result{raster::Framebuffer(viewport, scene.background), {}};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    for (const Object& object : scene.objects) {
        result.counts +=
            draw_polygons(placed(object, frame), PlainTechnique(scene.background), frame, settings,
                          result.framebuffer.depth, result.framebuffer.color);
    }
    return result;
}

raster::Plane<glm::vec3> draw_normals(const Scene& scene, const Settings& settings,
                                      raster::Viewport viewport) {
    raster::Plane<raster::Depth> depth(viewport, raster::depth_clear);
    raster::Plane<glm::vec3> normals(viewport, glm::vec3(0.0f));
    const Frame frame = frame_of(scene, settings.distances, viewport);
    for (const Object& object : scene.objects) {
        const PlacedMesh mesh = placed(object, frame);
        draw_polygons(mesh, NormalTechnique(mesh), frame, settings, depth, normals);
    }
    return normals;
}

raster::Plane<std::uint32_t> draw_ids(const Scene& scene, const Settings& settings,
                                      raster::Viewport viewport) {
    raster::Plane<raster::Depth> depth(viewport, raster::depth_clear);
    raster::Plane<std::uint32_t> ids(viewport, 0);
    const Frame frame = frame_of(scene, settings.distances, viewport);
    std::uint32_t first_id = 1;
    for (const Object& object : scene.objects) {
        const PlacedMesh mesh = placed(object, frame);
        draw_polygons(mesh, IdTechnique(mesh, first_id), frame, settings, depth, ids);
        if (!object.mesh->face_id.empty()) first_id += object.mesh->face_id.back() + 1;
    }
    return ids;
}

raster::Plane<float> eye_distances(const raster::Plane<raster::Depth>& depth,
                                   const Camera& camera) {
    raster::Plane<float> distances({depth.width(), depth.height()}, 0.0f);
    const double n = camera.near;
    const double f = camera.far;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (depth.at(x, y) == raster::depth_clear) continue;
            const double z = raster::ndc_from_depth(depth.at(x, y));
            distances.at(x, y) = static_cast<float>(camera.projection == Projection::perspective
                                                        ? n * f / (f - z * (f - n))
                                                        : n + z * (f - n));
        }
    }
    return distances;
}

}  // namespace scanlight::render
