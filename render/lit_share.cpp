#include "render/lit_share.h"

#include "render/draw_details.h"
#include "render/light_view.h"
#include "render/shadow_map.h"
#include "render/shadows.h"

namespace scanlight::render {

namespace {

using Shares = raster::Plane<float>;

/// `share(x, y)` of each pixel.
template <class Share>
Shares shares_of(raster::Viewport viewport, Share&& share) {
    Shares shares(viewport, 1.0f);
    for (int y = 0; y < viewport.height; ++y) {
        for (int x = 0; x < viewport.width; ++x)
            shares.at(x, y) = share(x, y);
    }
    return shares;
}

Shares by_volumes(const Scene& scene, const Settings& settings, std::size_t light,
                  const raster::Plane<raster::Depth>& depth) {
    const auto counts = count_shadows(scene, settings, light, depth);
    return shares_of({depth.width(), depth.height()},
                     [&](int x, int y) { return counts.at(x, y) == 0 ? 1.0f : 0.0f; });
}

Shares by_map(const Scene& scene, const Settings& settings, std::size_t light,
              const raster::Plane<raster::Depth>& depth) {
    const raster::Viewport viewport{depth.width(), depth.height()};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    const ShadowMap map = drawn_shadow_map(scene.objects, homogeneous(frame.lighting.lights[light]),
                                           settings.shadow_map);
    return shares_of(viewport, [&](int x, int y) {
        const raster::Depth z = depth.at(x, y);
        return z < raster::depth_clear ? map.share(frame.point_at(x, y, z)) : 1.0f;
    });
}

/// What shows a lit detail has its light.
Shares by_polygons(const Scene& scene, const Settings& settings, std::size_t light,
                   raster::Viewport viewport) {
    const Frame frame = frame_of(scene, settings.distances, viewport);
    const auto details = detail_polygons(scene.objects, homogeneous(frame.lighting.lights[light]));
    const auto seen = draw_details(scene, settings, details, viewport);
    return shares_of(viewport, [&](int x, int y) { return seen.at(x, y) != 0 ? 1.0f : 0.0f; });
}

}  // namespace

Shares lit_share(const Scene& scene, const Settings& settings, std::size_t light,
                 const raster::Plane<raster::Depth>& depth) {
    if (counts_volumes(settings.shadows)) return by_volumes(scene, settings, light, depth);
    if (settings.shadows == Shadows::map) return by_map(scene, settings, light, depth);
    const raster::Viewport viewport{depth.width(), depth.height()};
    if (settings.shadows == Shadows::polygons) return by_polygons(scene, settings, light, viewport);
    return {viewport, 1.0f};
}

}  // namespace scanlight::render
