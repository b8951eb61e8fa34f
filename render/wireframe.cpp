#include "render/wireframe.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
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

/// The smaller of the changes of depth to the two neighbours in a row or column: that on the same
/// surface, next to an outline too.
raster::Depth change(raster::Depth before, raster::Depth here, raster::Depth after) {
    return std::min(std::abs(here - before), std::abs(after - here));
}

/// How much the surface's depth changes over a pixel, as it is stored about (x, y).
raster::Depth steepness(const raster::Plane<raster::Depth>& depth, int x, int y) {
    const auto stored = [&](int i, int j) {
        const bool inside = i >= 0 && i < depth.width() && j >= 0 && j < depth.height();
        return inside ? depth.at(i, j) : raster::depth_clear;
    };
    const raster::Depth here = depth.at(x, y);
    return change(stored(x - 1, y), here, stored(x + 1, y)) +
           change(stored(x, y - 1), here, stored(x, y + 1));
}

/// A line runs beside the pixels' centres, where a steep surface has another depth.
bool is_hidden(const raster::LinePixel& pixel, const raster::Plane<raster::Depth>& depth) {
    const std::int64_t behind = std::int64_t{pixel.depth} - depth.at(pixel.x, pixel.y);
    return behind > depth_slack && behind > depth_slack + steepness(depth, pixel.x, pixel.y);
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
                    if (hidden == HiddenLines::removed && is_hidden(pixel, target.depth)) return;
                    target.color.at(pixel.x, pixel.y) = color;
                });
        }
    }
}

}  // namespace scanlight::render
