#include "render/wireframe.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "raster/line.h"
#include "render/frame.h"
#include "render/placed_mesh.h"
#include "render/screen_polygons.h"
#include "render/surface_data.h"

namespace scanlight::render {

namespace {

/// By how much depth grows over a thousandth of the distance. In perspective z = end (1 - near /
/// distance), where end = far / (far - near) is the depth of what is infinitely far: the change is
/// end - z, times that share.
class Slack {
public:
    explicit Slack(const Camera& camera)
        : end_(camera.far / (camera.far - camera.near)),
          is_perspective_(camera.projection == Projection::perspective) {}

    double at(raster::Depth depth) const {
        const double range = raster::depth_far;
        const double left = is_perspective_ ? end_ * range - depth : range;
        return share * std::max(left, 0.0);
    }

private:
    static constexpr double share = 1.0 / 1000.0;

    double end_;
    bool is_perspective_;
};

using Line = std::pair<std::uint32_t, std::uint32_t>;  // vertices, the lower index first

void append_edges(std::vector<Line>& lines, std::span<const std::uint32_t> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        lines.push_back(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
    }
}

/// Each edge once, however many polygons share it; none that only culled polygons have.
std::vector<Line> edges_of(const PlacedMesh& placed, const Frame& frame, const Settings& settings) {
    const mesh::Mesh& mesh = *placed.mesh;
    const PlainTechnique plain(raster::Rgba(0.0f));
    const ScreenPolygons<PlainTechnique> polygons(placed, plain, frame, settings);
    std::vector<Line> lines;
    lines.reserve(mesh.corners.size());
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const bool culled = settings.cull != Cull::none && polygons[face].fate == Fate::culled;
        if (!culled) append_edges(lines, mesh.face(face));
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
bool is_hidden(const raster::LinePixel& pixel, const Slack& slack,
               const raster::Plane<raster::Depth>& depth) {
    const raster::Depth stored = depth.at(pixel.x, pixel.y);
    const double behind = static_cast<double>(std::int64_t{pixel.depth} - stored);
    const double allowed = slack.at(stored);
    return behind > allowed && behind > allowed + steepness(depth, pixel.x, pixel.y);
}

void draw_line(const raster::ScreenVertex<0>& a, const raster::ScreenVertex<0>& b,
               const Slack& slack, raster::Rgba color, HiddenLines hidden,
               raster::Framebuffer& target) {
    raster::draw_line(a, b, target.size(), [&](const raster::LinePixel& pixel) {
        if (hidden == HiddenLines::removed && is_hidden(pixel, slack, target.depth)) return;
        target.color.at(pixel.x, pixel.y) = color;
    });
}

}  // namespace

void draw_visible_line(const raster::ScreenVertex<0>& a, const raster::ScreenVertex<0>& b,
                       const Camera& camera, raster::Rgba color, raster::Framebuffer& target) {
    draw_line(a, b, Slack(camera), color, HiddenLines::removed, target);
}

void draw_wireframe(const Scene& scene, raster::Rgba color, HiddenLines hidden,
                    raster::Framebuffer& target, const Settings& settings) {
    const Frame frame = frame_of(scene, Distances::finite, target.size());
    const Slack slack(scene.camera);
    for (const Object& object : scene.objects) {
        const PlacedMesh mesh = placed(object, frame);
        for (const auto& [a, b] : edges_of(mesh, frame, settings_of(object, settings))) {
            const auto line = raster::clip_line({mesh.clip[a], {}}, {mesh.clip[b], {}});
            if (!line) continue;
            draw_line(raster::snapped<0>(line->first.position, frame.viewport),
                      raster::snapped<0>(line->second.position, frame.viewport), slack, color,
                      hidden, target);
        }
    }
}

}  // namespace scanlight::render
