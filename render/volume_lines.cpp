#include "render/volume_lines.h"

#include "mesh/silhouette.h"
#include "raster/line.h"
#include "render/frame.h"
#include "render/light_view.h"
#include "render/shadow_volume.h"

namespace scanlight::render {

namespace {

glm::dvec2 pixels(const raster::ClipVertex<0>& vertex, raster::Viewport viewport) {
    const auto place = raster::snapped<0>(vertex.position, viewport);
    return glm::dvec2(place.x, place.y) / static_cast<double>(raster::subpixels);
}

template <class Polygon>
void append_outline(const Polygon& corners, raster::Viewport viewport,
                    std::vector<PictureLine>& lines) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto line = raster::clip_line(corners[i], corners[(i + 1) % corners.size()]);
        if (line) lines.push_back({pixels(line->first, viewport), pixels(line->second, viewport)});
    }
}

}  // namespace

std::vector<PictureLine> volume_lines(const Scene& scene, const Settings& settings,
                                      std::size_t object, std::size_t light,
                                      raster::Viewport viewport) {
    const Frame frame = frame_of(scene, settings.distances, viewport);
    const Object& caster = scene.objects.at(object);
    const mesh::SilhouetteFinder finder(*caster.mesh);
    const ShadowVolume volume(caster, finder, homogeneous(frame.lighting.lights.at(light)), frame);
    std::vector<PictureLine> lines;
    volume.for_each_side([&](const auto& corners, std::int32_t, const mesh::SilhouetteEdge&) {
        append_outline(corners, viewport, lines);
    });
    return lines;
}

}  // namespace scanlight::render
