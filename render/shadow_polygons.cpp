#include "render/shadow_polygons.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

#include "render/light_view.h"
#include "render/polygon_clipping.h"

namespace scanlight::render {

namespace {

/// The light's picture reaches from -1 to 1.
constexpr double grid_units = 0x1p28;

// ---- polygons before the light

/// The part of a polygon where `distance` is not below 0 (Sutherland & Hodgman 1974). A crossing is
/// computed from the inside, so that polygons that share the edge get the same bits.
template <class Distance>
Corners clipped(const Corners& polygon, Distance&& distance) {
    const auto crossing = [](const glm::dvec3& inside, double d_in, const glm::dvec3& outside,
                             double d_out) {
        return inside + d_in / (d_in - d_out) * (outside - inside);
    };
    Corners result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_a = distance(a);
        const double at_b = distance(b);
        if (at_a >= 0.0) result.push_back(a);
        if (at_a >= 0.0 && at_b < 0.0) result.push_back(crossing(a, at_a, b, at_b));
        if (at_a < 0.0 && at_b >= 0.0) result.push_back(crossing(b, at_b, a, at_a));
    }
    return result;
}

/// The part of a polygon in a view. One of parallel rays sees all.
Corners in_view(Corners polygon, const LightView& view, double nearest) {
    if (view.is_parallel()) return polygon;
    const auto clip = [&](auto&& distance) {
        polygon = clipped(polygon, [&](const glm::dvec3& point) {
            const glm::dvec3 p = view.in_eye_space(point);
            return distance(p.x, p.y, -p.z);
        });
    };
    clip([&](double, double, double ahead) { return ahead - nearest; });
    clip([](double x, double, double ahead) { return ahead - x; });
    clip([](double x, double, double ahead) { return ahead + x; });
    clip([](double, double y, double ahead) { return ahead - y; });
    clip([](double, double y, double ahead) { return ahead + y; });
    return polygon;
}

/// Turned so that the light is before it. With no normal if the light sees it edge-on.
OrientedPlane turned_to(const glm::dvec4& light, OrientedPlane plane, double flatness) {
    const double side = glm::dot(plane.normal, glm::dvec3(light)) - light.w * plane.offset;
    const double least = light.w == 0.0 ? 1e-9 : flatness;
    if (!(std::abs(side) > least)) return {};
    return side > 0.0 ? plane : OrientedPlane{-plane.normal, -plane.offset};
}

// ---- the light's picture

GridPoint grid_point(const glm::dvec3& point, const LightView& view) {
    const glm::dvec3 place = view.seen(point);
    return {std::llrint(place.x * grid_units), std::llrint(place.y * grid_units)};
}

GridOutline on_grid(const Corners& polygon, const LightView& view) {
    GridOutline outline;
    for (const glm::dvec3& corner : polygon)
        outline.push_back(grid_point(corner, view));
    return outline;
}

struct GridBox {
    GridPoint low{grid_limit, grid_limit};
    GridPoint high{-grid_limit, -grid_limit};
};

GridBox box_of(const GridOutline& outline) {
    GridBox box;
    for (const GridPoint& p : outline) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

/// A polygon in the light's picture, or as much of it as is there.
struct SeenPolygon {
    std::size_t parent;   // its face's place among all
    OrientedPlane plane;  // turned to the light
    Corners corners;
    GridOutline outline;
    GridBox box;
};

/// Calls `visit(a, b)` for each two whose boxes overlap: a sweep over the boxes from left to right.
template <class Visit>
void for_each_overlap(const std::vector<SeenPolygon>& polygons, Visit&& visit) {
    std::vector<std::uint32_t> order(polygons.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return polygons[i].box.low.x; });
    std::vector<std::uint32_t> active;
    for (const std::uint32_t i : order) {
        const GridBox& box = polygons[i].box;
        std::erase_if(active, [&](std::uint32_t j) { return polygons[j].box.high.x <= box.low.x; });
        for (const std::uint32_t j : active) {
            const GridBox& other = polygons[j].box;
            if (other.low.y < box.high.y && box.low.y < other.high.y) visit(i, j);
        }
        active.push_back(i);
    }
}

/// Thinner than what rounding to the grid leaves.
bool is_sliver(const GridOutline& outline) {
    double length = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const GridPoint& a = outline[i];
        const GridPoint& b = outline[i + 1 < outline.size() ? i + 1 : 0];
        length += static_cast<double>(std::abs(a.x - b.x) + std::abs(a.y - b.y));
    }
    return std::abs(signed_area(outline)) <= length;
}

/// One picture of the light's, and what it shows of each polygon.
class DetailView {
public:
    DetailView(const Camera& camera, double flatness) : view_(camera), flatness_(flatness) {}

    void add(std::size_t parent, const OrientedPlane& plane, const Corners& polygon) {
        Corners corners = in_view(polygon, view_, flatness_);
        if (corners.size() < 3) return;
        GridOutline outline = on_grid(corners, view_);
        if (is_sliver(outline)) return;  // seen edge-on, or touched by the view's edge
        if (signed_area(outline) < 0.0) {
            std::ranges::reverse(corners);
            std::ranges::reverse(outline);
        }
        const GridBox box = box_of(outline);
        polygons_.push_back({parent, plane, std::move(corners), std::move(outline), box});
    }

    /// Calls `visit(parent, outlines, whole)` with the part of each polygon.
    template <class Visit>
    void for_each_part(LightPart part, Visit&& visit) const {
        const auto blockers = find_blockers();
        for (std::size_t i = 0; i < polygons_.size(); ++i) {
            const SeenPolygon& polygon = polygons_[i];
            if (!blockers[i].empty()) {
                visit(polygon.parent, cut(polygon, blockers[i], part), false);
            } else if (part == LightPart::lit) {
                visit(polygon.parent, std::vector<Corners>{polygon.corners}, true);
            }
        }
    }

private:
    using Numbers = std::vector<std::uint32_t>;

    /// For each polygon those of which something may be over it.
    std::vector<Numbers> find_blockers() const {
        std::vector<Numbers> blockers(polygons_.size());
        for_each_overlap(polygons_, [&](std::uint32_t a, std::uint32_t b) {
            if (is_before(polygons_[a], polygons_[b].plane)) blockers[b].push_back(a);
            if (is_before(polygons_[b], polygons_[a].plane)) blockers[a].push_back(b);
        });
        for (Numbers& of_one : blockers)
            std::ranges::sort(of_one);
        return blockers;
    }

    /// Whether something of a polygon is between a plane and the light.
    bool is_before(const SeenPolygon& polygon, const OrientedPlane& plane) const {
        return std::ranges::any_of(polygon.corners, [&](const glm::dvec3& corner) {
            return plane.distance(corner) > flatness_;
        });
    }

    GridOutline part_before(const SeenPolygon& polygon, const OrientedPlane& plane) const {
        const auto distance = [&](const glm::dvec3& point) { return plane.distance(point); };
        const bool crosses = std::ranges::any_of(
            polygon.corners, [&](const glm::dvec3& p) { return distance(p) < -flatness_; });
        return crosses ? on_grid(clipped(polygon.corners, distance), view_) : polygon.outline;
    }

    std::vector<Corners> cut(const SeenPolygon& polygon, const Numbers& blockers,
                             LightPart part) const {
        std::vector<GridOutline> others;
        for (const std::uint32_t i : blockers)
            others.push_back(part_before(polygons_[i], polygon.plane));
        const GridRegion region = part == LightPart::lit ? uncovered(polygon.outline, others)
                                                         : covered(polygon.outline, others);
        std::vector<Corners> outlines;
        for (const GridOutline& outline : region) {
            if (!is_sliver(outline)) outlines.push_back(carried_back(outline, polygon));
        }
        return outlines;
    }

    /// Into the polygon's plane; its own corners are as they were.
    Corners carried_back(const GridOutline& outline, const SeenPolygon& polygon) const {
        Corners corners;
        for (const GridPoint& point : outline) {
            const auto own = std::ranges::find(polygon.outline, point);
            corners.push_back(
                own == polygon.outline.end()
                    ? carried_back(point, polygon.plane)
                    : polygon.corners[static_cast<std::size_t>(own - polygon.outline.begin())]);
        }
        return corners;
    }

    glm::dvec3 carried_back(const GridPoint& point, const OrientedPlane& plane) const {
        const auto [origin, direction] = view_.ray(static_cast<double>(point.x) / grid_units,
                                                   static_cast<double>(point.y) / grid_units);
        const double t = -plane.distance(origin) / glm::dot(plane.normal, direction);
        return origin + t * direction;
    }

    LightView view_;
    double flatness_;
    std::vector<SeenPolygon> polygons_;
};

void show(const FlatFace& face, std::size_t parent, const glm::dvec4& light, double flatness,
          std::vector<DetailView>& views) {
    for (const Corners& polygon : face.polygons) {
        const OrientedPlane plane = turned_to(light, plane_of(polygon), flatness);
        if (plane.normal == glm::dvec3(0.0)) continue;
        for (DetailView& view : views)
            view.add(parent, plane, polygon);
    }
}

/// Without faces that have no such part; those that are whole have their own outline.
std::vector<DetailPolygon> tidied(std::vector<DetailPolygon> details,
                                  const std::vector<FlatFace>& faces) {
    for (std::size_t i = 0; i < details.size(); ++i) {
        if (details[i].whole) details[i].outlines.assign(1, faces[i].corners);
    }
    std::erase_if(details, [](const DetailPolygon& detail) { return detail.outlines.empty(); });
    return details;
}

}  // namespace

std::vector<DetailPolygon> detail_polygons(const std::vector<Object>& objects,
                                           const glm::dvec4& light, LightPart part) {
    const double flat = flatness(objects);
    const std::vector<FlatFace> faces = flat_faces(objects, flat);
    std::vector<DetailView> views;
    for (const Camera& camera : light_cameras(light, objects))
        views.emplace_back(camera, flat);
    std::vector<DetailPolygon> details;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        details.push_back({faces[i].object,
                           faces[i].face,
                           false,
                           turned_to(light, plane_of(faces[i].corners), flat),
                           {}});
        show(faces[i], i, light, flat, views);
    }
    std::vector<bool> has_part(faces.size(), false);
    std::vector<bool> is_cut(faces.size(), false);
    for (const DetailView& view : views) {
        view.for_each_part(
            part, [&](std::size_t parent, std::vector<Corners> outlines, bool whole) {
                has_part[parent] = true;
                is_cut[parent] = is_cut[parent] || !whole;
                std::ranges::move(outlines, std::back_inserter(details[parent].outlines));
            });
    }
    for (std::size_t i = 0; i < details.size(); ++i)
        details[i].whole = has_part[i] && !is_cut[i];
    return tidied(std::move(details), faces);
}

}  // namespace scanlight::render
