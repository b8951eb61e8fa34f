#include "render/wireframe.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "raster/line.h"
#include "render/frame.h"
#include "render/placed_mesh.h"

namespace scanlight::render {

namespace {

constexpr raster::Depth depth_slack = raster::depth_far / 1000;

using Line = std::pair<std::uint32_t, std::uint32_t>;  // vertices, the lower index first

/// Each edge once, however many polygons share it.
std::vector<Line> edges_of(const mesh::Mesh& mesh) {
    std::vector<Line> lines;
    lines.reserve(mesh.corners.size());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const auto corners = mesh.face(face);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            lines.push_back(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
        }
    }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

}  // namespace

void draw_wireframe(const Scene& scene, raster::Rgba color, HiddenLines hidden,
                    raster::Framebuffer& target) {
    const Frame frame = frame_of(scene, Distances::finite, target.size());
    for (const Object& object : scene.objects) {
        const PlacedMesh mesh = placed(object, frame);
        for (const auto& [a, b] : edges_of(*object.mesh)) {
            const auto line = raster::clip_line({mesh.clip[a], {}}, {mesh.clip[b], {}});
            if (!line) continue;
            raster::draw_line(
                raster::snapped<0>(line->first.position, frame.viewport),
                raster::snapped<0>(line->second.position, frame.viewport), frame.viewport,
                [&](const raster::LinePixel& pixel) {
                    const auto nearest = target.depth.at(pixel.x, pixel.y);
                    if (hidden == HiddenLines::removed && pixel.depth - depth_slack > nearest)
                        return;
                    target.color.at(pixel.x, pixel.y) = color;
                });
        }
    }
}

}  // namespace scanlight::render
