#include "render/layers.h"

#include <span>
#include <utility>
#include <vector>

#include "render/draw_with_shadows.h"
#include "render/lit_share.h"
#include "render/opacity.h"
#include "render/technique.h"

namespace scanlight::render {

namespace {

using Layer = raster::Layer<raster::Rgba>;

/// Where a layer begins: behind the one before it.
struct Before {
    raster::Plane<raster::Depth> depth;
    raster::Plane<std::int32_t> number;
};

/// Draws layers of a scene, all the surfaces of which are transparent.
class LayerDrawer {
public:
    LayerDrawer(const Settings& settings, const raster::Plane<raster::Depth>& end)
        : settings_(settings), viewport_{end.width(), end.height()}, end_(end) {}

    /// Its alpha is the opacity; where there is no surface any more it is 0.
    Layer draw(const Scene& lit, const Before& before, DrawCounts& counts) const {
        Layer layer(viewport_, end_, raster::Rgba(0.0f));
        const Frame frame = frame_of(lit, settings_.distances, viewport_);
        std::int32_t first = 0;
        for (const Object& object : lit.objects) {
            counts += draw_object(object, frame, first, before, layer);
            first += static_cast<std::int32_t>(object.mesh->face_count());
        }
        return layer;
    }

private:
    DrawCounts draw_object(const Object& object, const Frame& frame, std::int32_t first,
                           const Before& before, Layer& layer) const {
        const PlacedMesh mesh = placed(object, frame);
        const Settings settings = settings_of(object, settings_);
        return with_technique(mesh, frame, settings, [&](const auto& technique) {
            const auto draw_span = [&](std::size_t face, const auto& span, const auto& shade) {
                return raster::draw_span_behind(span, first + static_cast<std::int32_t>(face),
                                                before.depth, before.number, layer, shade);
            };
            return draw_polygons(mesh, technique, frame, settings, draw_span);
        });
    }

    const Settings& settings_;
    raster::Viewport viewport_;
    const raster::Plane<raster::Depth>& end_;  // of the opaque surfaces
};

/// Adds what a light alone gives, as far as it reaches the surfaces.
void add_light(const Layer& lit, const raster::Plane<float>& shares, Layer& sum) {
    for (int y = 0; y < sum.target.height(); ++y) {
        for (int x = 0; x < sum.target.width(); ++x) {
            const float share = shares.at(x, y);
            if (share == 0.0f) continue;
            sum.target.at(x, y) += raster::Rgba(share * glm::vec3(lit.target.at(x, y)), 0.0f);
        }
    }
}

/// Detail polygons lie on opaque surfaces only.
Settings shadows_on_layers(Settings settings) {
    if (settings.shadows == Shadows::polygons) settings.shadows = Shadows::zfail;
    return settings;
}

/// In all light that reaches it.
Layer lit_layer(const SplitScene& scenes, const Settings& settings, const LayerDrawer& drawer,
                const Before& before, DrawCounts& counts) {
    const Scene& scene = scenes.transparent;
    if (settings.shadows == Shadows::none) return drawer.draw(scene, before, counts);
    const Settings method = shadows_on_layers(settings);
    Layer sum = drawer.draw(lit_by(scene, {scene.lighting.ambient, {}}), before, counts);
    for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
        DrawCounts again;
        const auto shares = lit_share(scenes.opaque, method, i, sum.depth);
        add_light(drawer.draw(lit_by_one(scene, i), before, again), shares, sum);
    }
    return sum;
}

/// What each transparent face, by its number in a layer, leaves of light that comes through it.
std::vector<glm::vec3> filters_of(const Scene& scene) {
    std::vector<glm::vec3> filters;
    for (const Object& object : scene.objects) {
        for (std::size_t face = 0; face < object.mesh->face_count(); ++face)
            filters.push_back(filter_of(object, face));
    }
    return filters;
}

void add_layer(const Layer& layer, std::span<const glm::vec3> filters,
               raster::Plane<Blend>& blends) {
    for (int y = 0; y < blends.height(); ++y) {
        for (int x = 0; x < blends.width(); ++x) {
            const std::int32_t number = layer.number.at(x, y);
            if (number < 0) continue;
            const raster::Rgba& color = layer.target.at(x, y);
            blends.at(x, y).add(glm::vec3(color), color.a,
                                filters[static_cast<std::size_t>(number)]);
        }
    }
}

/// The polygons are the same in each layer.
DrawCounts pixels_only(DrawCounts counts) {
    counts.polygons = counts.outside = counts.culled = counts.drawn = 0;
    return counts;
}

void lay_over(const raster::Plane<Blend>& blends, raster::Plane<raster::Rgba>& color) {
    for (int y = 0; y < color.height(); ++y) {
        for (int x = 0; x < color.width(); ++x) {
            const Blend& blend = blends.at(x, y);
            if (blend.is_clear()) continue;
            color.at(x, y) = blend.over(color.at(x, y));
        }
    }
}

}  // namespace

Drawing draw_with_layers(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    const SplitScene scenes = split_by_opacity(scene);
    Drawing result = draw_opaque(scenes.opaque, settings, viewport);
    const LayerDrawer drawer(settings, result.framebuffer.depth);
    const auto filters = filters_of(scenes.transparent);
    raster::Plane<Blend> blends(viewport, {});
    Before before{{viewport, -1}, {viewport, -1}};
    for (int i = 0; i < most_layers; ++i) {
        DrawCounts counts;
        Layer layer = lit_layer(scenes, settings, drawer, before, counts);
        result.counts += i == 0 ? counts : pixels_only(counts);
        if (counts.pixels_passed == 0) break;
        add_layer(layer, filters, blends);
        before = {std::move(layer.depth), std::move(layer.number)};
    }
    lay_over(blends, result.framebuffer.color);
    return result;
}

}  // namespace scanlight::render
