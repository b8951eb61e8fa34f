#include "render/draw.h"

#include <utility>

#include "raster/box_filter.h"
#include "render/draw_with_shadows.h"
#include "render/layers.h"
#include "render/opacity.h"
#include "render/surface_data.h"
#include "render/surroundings.h"
#include "render/technique.h"

namespace scanlight::render {

namespace {

DrawCounts draw_object(const PlacedMesh& placed, const Frame& frame, const Settings& settings,
                       raster::Framebuffer& target) {
    return with_technique(placed, frame, settings, [&](const auto& technique) {
        return draw_polygons(placed, technique, frame, settings, target.depth, target.color);
    });
}

/// Where nothing else is.
void draw_surroundings(const Frame& frame, raster::Framebuffer& target) {
    for (int y = 0; y < frame.viewport.height; ++y) {
        for (int x = 0; x < frame.viewport.width; ++x) {
            if (target.depth.at(x, y) == raster::depth_clear)
                target.color.at(x, y) = surroundings_at(frame, x, y);
        }
    }
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

namespace {

/// Draws a picture with a pixel for each sample, and averages.
Drawing draw_samples(const Scene& scene, Settings settings, raster::Viewport viewport) {
    const int grid = std::exchange(settings.grid, 1);
    const Drawing samples = draw(scene, settings, size_in_samples(viewport, grid));
    Drawing result = draw_opaque_depth(scene, settings, viewport);
    result.counts = samples.counts;
    for (int y = 0; y < viewport.height; ++y)
        raster::average_rows(samples.framebuffer.color, y * grid, result.framebuffer.color.row(y));
    return result;
}

}  // namespace

Drawing draw(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    if (settings.grid > 1) return draw_samples(scene, settings, viewport);
    if (has_transparent(scene)) return draw_with_layers(scene, settings, viewport);
    return draw_opaque(scene, settings, viewport);
}

Drawing draw_opaque(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    if (settings.shadows != Shadows::none) return draw_with_shadows(scene, settings, viewport);
    Drawing result{raster::Framebuffer(viewport, scene.background), {}};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    for (const Object& object : scene.objects) {
        result.counts += draw_object(placed(object, frame), frame, settings_of(object, settings),
                                     result.framebuffer);
    }
    if (frame.surroundings != nullptr) draw_surroundings(frame, result.framebuffer);
    return result;
}

Drawing draw_depth(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    Drawing result{raster::Framebuffer(viewport, scene.background), {}};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    for (const Object& object : scene.objects) {
        result.counts += draw_polygons(placed(object, frame), PlainTechnique(scene.background),
                                       frame, settings_of(object, settings),
                                       result.framebuffer.depth, result.framebuffer.color);
    }
    return result;
}

Drawing draw_opaque_depth(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    return has_transparent(scene) ? draw_depth(split_by_opacity(scene).opaque, settings, viewport)
                                  : draw_depth(scene, settings, viewport);
}

Drawing draw_fresnel(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    Drawing result{raster::Framebuffer(viewport, scene.background), {}};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    for (const Object& object : scene.objects) {
        const PlacedMesh mesh = placed(object, frame);
        result.counts +=
            draw_polygons(mesh, FresnelTechnique(mesh, frame), frame, settings_of(object, settings),
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
        draw_polygons(mesh, NormalTechnique(mesh), frame, settings_of(object, settings), depth,
                      normals);
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
        draw_polygons(mesh, IdTechnique(mesh, first_id), frame, settings_of(object, settings),
                      depth, ids);
        if (!object.mesh->face_id.empty()) first_id += object.mesh->face_id.back() + 1;
    }
    return ids;
}

raster::Plane<std::uint32_t> draw_items(const Scene& scene, const Settings& settings,
                                        raster::Viewport viewport) {
    raster::Plane<raster::Depth> depth(viewport, raster::depth_clear);
    raster::Plane<std::uint32_t> items(viewport, 0);
    const Frame frame = frame_of(scene, settings.distances, viewport);
    std::uint32_t first_item = 1;
    for (const Object& object : scene.objects) {
        const PlacedMesh mesh = placed(object, frame);
        draw_polygons(mesh, ItemTechnique(first_item), frame, settings_of(object, settings), depth,
                      items);
        first_item += static_cast<std::uint32_t>(object.mesh->face_count());
    }
    return items;
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
