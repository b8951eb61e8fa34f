#include "render/draw_details.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include <glm/geometric.hpp>

#include "raster/clip.h"
#include "raster/clip_volume.h"
#include "raster/fill.h"
#include "raster/line.h"
#include "render/draw.h"
#include "render/frame.h"

namespace scanlight::render {

namespace {

using raster::BareClipPolygon;
using raster::BareScreenPolygon;

BareClipPolygon in_clip_space(const Corners& outline, const Frame& frame) {
    BareClipPolygon polygon;
    for (const glm::dvec3& corner : outline)
        polygon.push_back({glm::vec4(frame.clip_from_world * glm::dvec4(corner, 1.0)), {}});
    return polygon;
}

/// Calls `visit(a, b)` with the ends of each edge that is in the view, on the screen.
template <class Visit>
void for_each_edge(const BareClipPolygon& polygon, raster::Viewport viewport, Visit&& visit) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const auto line = raster::clip_line(polygon[i], next);
        if (!line) continue;
        visit(raster::snapped<0>(line->first.position, viewport),
              raster::snapped<0>(line->second.position, viewport));
    }
}

/// A strip along an edge, 1/32 pixel wide.
BareScreenPolygon strip(raster::ScreenVertex<0> a, raster::ScreenVertex<0> b) {
    constexpr raster::SubPixel half_width = raster::subpixels / 64;
    const bool is_steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    const auto beside = [&](raster::ScreenVertex<0> v, raster::SubPixel step) {
        (is_steep ? v.x : v.y) += step;
        return v;
    };
    return {beside(a, -half_width), beside(b, -half_width), beside(b, half_width),
            beside(a, half_width)};
}

/// Marks the pixels of a face that its details cover.
class DetailPainter {
public:
    DetailPainter(const Frame& frame, const raster::Plane<std::uint32_t>& items)
        : frame_(frame), items_(items), marks_(frame.viewport, 0) {}

    /// First what lies in an odd number of outlines; then the outlines, a little wider than they
    /// are: their corners are rounded, and no seam may show along the edges of the face and of its
    /// parts.
    void paint(const DetailPolygon& detail, std::uint32_t item) {
        for (const Corners& outline : detail.outlines) {
            const auto polygon = raster::clip(in_clip_space(outline, frame_));
            fill(raster::project_affine(polygon, frame_.viewport), item,
                 [](std::uint8_t& mark) { mark ^= 1; });
        }
        for (const Corners& outline : detail.outlines) {
            const auto polygon = in_clip_space(outline, frame_);
            for_each_edge(polygon, frame_.viewport, [&](const auto& a, const auto& b) {
                fill(strip(a, b), item, [](std::uint8_t& mark) { mark = 1; });
            });
        }
    }

    void paint_all(std::uint32_t item) {
        whole_.resize(std::max<std::size_t>(whole_.size(), item + 1), false);
        whole_[item] = true;
    }

    raster::Plane<std::uint8_t> marks() && {
        for (int y = 0; y < marks_.height(); ++y) {
            for (int x = 0; x < marks_.width(); ++x) {
                const std::uint32_t item = items_.at(x, y);
                if (item < whole_.size() && whole_[item]) marks_.at(x, y) = 1;
            }
        }
        return std::move(marks_);
    }

private:
    template <class Mark>
    void fill(const BareScreenPolygon& polygon, std::uint32_t item, Mark&& mark) {
        const auto emit = [&](const raster::Span<0>& span) {
            for (int x = std::max(span.x_begin, 0); x < std::min(span.x_end, marks_.width()); ++x) {
                if (items_.at(x, span.y) == item) mark(marks_.at(x, span.y));
            }
        };
        filler_.fill(std::span(polygon), raster::Interpolation::planar, emit, raster::NoObserver{},
                     {0, marks_.height()});
    }

    const Frame& frame_;
    const raster::Plane<std::uint32_t>& items_;
    raster::Plane<std::uint8_t> marks_;
    std::vector<bool> whole_;  // by items
    raster::PolygonFiller<0> filler_;
};

bool faces_eye(const DetailPolygon& detail, const Frame& frame) {
    const auto& [normal, offset] = detail.plane;
    const glm::dvec4 eye(frame.viewpoint);
    return glm::dot(normal, glm::dvec3(eye)) - eye.w * offset > 0.0;
}

/// The number of each object's first face among those of all, from 1.
std::vector<std::uint32_t> first_items(const Scene& scene) {
    std::vector<std::uint32_t> first{1};
    for (const Object& object : scene.objects)
        first.push_back(first.back() + static_cast<std::uint32_t>(object.mesh->face_count()));
    return first;
}

}  // namespace

raster::Plane<std::uint8_t> draw_details(const Scene& scene, const Settings& settings,
                                         std::span<const DetailPolygon> details,
                                         raster::Viewport viewport) {
    // The true eye: that of `Distances::infinite` is for the illumination alone.
    const Frame frame = frame_of(scene, Distances::finite, viewport);
    const auto items = draw_items(scene, settings, viewport);
    const auto first = first_items(scene);
    DetailPainter painter(frame, items);
    for (const DetailPolygon& detail : details) {
        if (!faces_eye(detail, frame)) continue;
        const std::uint32_t item = first[detail.object] + static_cast<std::uint32_t>(detail.face);
        detail.whole ? painter.paint_all(item) : painter.paint(detail, item);
    }
    return std::move(painter).marks();
}

void draw_detail_outlines(const Scene& scene, std::span<const DetailPolygon> details,
                          raster::Rgba color, raster::Framebuffer& target) {
    const Frame frame = frame_of(scene, Distances::finite, target.size());
    for (const DetailPolygon& detail : details) {
        if (!faces_eye(detail, frame)) continue;
        for (const Corners& outline : detail.outlines) {
            const auto polygon = in_clip_space(outline, frame);
            for_each_edge(polygon, frame.viewport, [&](const auto& a, const auto& b) {
                draw_visible_line(a, b, scene.camera, color, target);
            });
        }
    }
}

}  // namespace scanlight::render
