#include "render/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/clip_volume.h"
#include "raster/fill.h"
#include "render/placed_mesh.h"

namespace scanlight::render {

namespace {

/// The faces of a cube are drawn a little wider than they are, so that the filter, and what is
/// rounded, stay within one.
Camera widened(Camera camera, const ShadowMapRule& rule) {
    if (camera.projection == Projection::perspective)
        camera.magnification *= 1.0 - (rule.filter + 1.0) / rule.size;
    return camera;
}

/// How the depths of planes change over a map.
class Slopes {
public:
    Slopes(const Frame& frame, int size)
        : planes_from_world_(glm::transpose(glm::inverse(frame.clip_from_world))),
          ndc_a_cell_(2.0 / size) {}

    /// From a cell to the next, across and down together, in units of depth; infinite where the
    /// light grazes the plane.
    double of(const glm::dvec3& normal, const glm::dvec3& point) const {
        const glm::dvec4 plane = planes_from_world_ * glm::dvec4(normal, -glm::dot(normal, point));
        const double slope = (std::abs(plane.x) + std::abs(plane.y)) / std::abs(plane.z);
        return slope * ndc_a_cell_ * raster::depth_far;
    }

private:
    glm::dmat4 planes_from_world_;
    double ndc_a_cell_;
};

/// Rounded, and not beyond the far plane, for an infinite one too.
raster::Depth depth_from(double depth) {
    const double far = raster::depth_far;
    return static_cast<raster::Depth>(std::llrint(depth < far ? std::max(depth, 0.0) : far));
}

/// 0 at the near plane, 1 at the far plane, as clip space has it; of a point before the camera.
double depth_at(double distance, const Camera& camera) {
    const double n = camera.near;
    const double f = camera.far;
    if (camera.projection == Projection::orthographic) return (distance - n) / (f - n);
    return f * (distance - n) / (distance * (f - n));
}

/// Draws depths alone, each polygon pushed back by its slope.
class DepthDrawer {
public:
    DepthDrawer(const LightView& view, double cells, raster::Plane<raster::Depth>& depth)
        : view_(view),
          frame_(frame_from(view.camera(), depth.width())),
          slopes_(frame_, depth.width()),
          cells_(cells),
          depth_(depth) {}

    /// Whether any of an object is seen.
    bool draw(const Object& object) {
        const PlacedMesh mesh = placed(object, frame_);
        bool any = false;
        for (std::size_t face = 0; face < mesh.mesh->face_count(); ++face) {
            const auto clipped = raster::clip(corners_of(mesh, face));
            if (clipped.size() < 3) continue;
            fill(on_map(clipped), depth_from(cells_ * slope(mesh, face)));
            any = true;
        }
        return any;
    }

private:
    static Frame frame_from(const Camera& camera, int size) {
        Scene seen;
        seen.camera = camera;
        return frame_of(seen, Distances::finite, {size, size});
    }

    static raster::BareClipPolygon corners_of(const PlacedMesh& mesh, std::size_t face) {
        raster::BareClipPolygon corners;
        for (const std::uint32_t vertex : mesh.mesh->face(face))
            corners.push_back({mesh.clip[vertex], {}});
        return corners;
    }

    double slope(const PlacedMesh& mesh, std::size_t face) const {
        const std::uint32_t corner = mesh.mesh->face(face).front();
        return slopes_.of(glm::dvec3(mesh.face_normals[face]), glm::dvec3(mesh.points[corner]));
    }

    raster::BareScreenPolygon on_map(const raster::BareClipPolygon& polygon) const {
        raster::BareScreenPolygon corners;
        for (const auto& vertex : polygon) {
            corners.push_back(raster::snapped<0>(vertex.position, frame_.viewport));
            corners.back().z = depth_from(ndc_depth(vertex.position) * raster::depth_far);
        }
        return corners;
    }

    /// In perspective from w: a float z / w tells little far behind a near plane that is close.
    double ndc_depth(const glm::vec4& clip) const {
        return view_.is_parallel() ? clip.z : depth_at(clip.w, view_.camera());
    }

    /// At each cell, not at the corners: what would lie beyond the far plane ends there.
    void fill(const raster::BareScreenPolygon& polygon, raster::Depth push) {
        const auto draw = [&](raster::Span<0> span) {
            const auto row = depth_.row(span.y);
            for (int x = span.x_begin; x < span.x_end; ++x, span.ramps.step()) {
                const std::int64_t z = std::int64_t{span.ramps.depth.get()} + push;
                raster::Depth& nearest = row[static_cast<std::size_t>(x)];
                nearest = static_cast<raster::Depth>(
                    std::min({z, std::int64_t{raster::depth_far}, std::int64_t{nearest}}));
            }
        };
        filler_.fill(std::span(polygon), raster::Interpolation::planar, draw);
    }

    const LightView& view_;
    Frame frame_;
    Slopes slopes_;
    double cells_;
    raster::Plane<raster::Depth>& depth_;
    raster::PolygonFiller<0> filler_;
};

/// The cell of a place from -1 to 1; outside of the map none of it.
int cell_of(double place, int size) {
    const double cell = std::floor(0.5 * (place + 1.0) * size);
    return static_cast<int>(std::clamp(cell, -1e6, 1e6));
}

std::size_t view_count(const shading::Light<float>& light) {
    return light.kind == shading::Light<float>::Kind::point ? 6 : 1;
}

}  // namespace

ShadowMap::ShadowMap(const std::vector<Object>& objects, const glm::dvec4& light,
                     const ShadowMapRule& rule)
    : light_(light), rule_(rule), reach_(rule.bias + 0.5 * (rule.filter - 1)) {
    for (const Camera& camera : light_cameras(light, objects))
        views_.push_back({LightView(widened(camera, rule)), {}});
}

void ShadowMap::draw(std::size_t view, const std::vector<Object>& objects) {
    auto& [seen, stored] = views_[view];
    raster::Plane<raster::Depth> depth({rule_.size, rule_.size}, raster::depth_clear);
    DepthDrawer drawer(seen, reach_, depth);
    bool any = false;
    for (const Object& object : objects)
        any = drawer.draw(object) || any;
    if (any) stored = std::move(depth);
}

float ShadowMap::share(const glm::vec3& point) const {
    const glm::dvec3 p(point);
    return share(views_[light_.w == 0.0 ? 0 : cube_face(p - glm::dvec3(light_))], p);
}

/// Of the depths of a view, about the cell in which a place lies.
float ShadowMap::share(const View& map, const glm::dvec3& point) const {
    const auto& [view, stored] = map;
    if (stored.width() == 0) return 1.0f;
    const glm::dvec3 place = view.seen(point);
    const double cell_width = 2.0 * view.half_width(place.z) / rule_.size;
    const double distance = place.z - reach_ * cell_width;
    if (!(distance > view.camera().near)) return 1.0f;
    const int cells = rule_.filter * rule_.filter;
    const int lit = lit_cells(stored, cell_of(place.x, rule_.size), cell_of(-place.y, rule_.size),
                              depth_at(distance, view.camera()) * raster::depth_far);
    return static_cast<float>(lit) / static_cast<float>(cells);
}

/// Of the cells about one, those in which nothing is nearer than a depth; what is beyond the map is
/// lit.
int ShadowMap::lit_cells(const raster::Plane<raster::Depth>& stored, int column, int row,
                         double depth) const {
    const int reach = rule_.filter / 2;
    int lit = 0;
    for (int y = row - reach; y <= row + reach; ++y) {
        for (int x = column - reach; x <= column + reach; ++x) {
            const bool inside = x >= 0 && x < rule_.size && y >= 0 && y < rule_.size;
            lit += !inside || depth <= stored.at(x, y) ? 1 : 0;
        }
    }
    return lit;
}

std::size_t ShadowMap::bytes() const {
    std::size_t sum = 0;
    for (const View& view : views_)
        sum += view.depth.values().size_bytes();
    return sum;
}

ShadowMap drawn_shadow_map(const std::vector<Object>& objects, const glm::dvec4& light,
                           const ShadowMapRule& rule) {
    ShadowMap map(objects, light, rule);
    for (std::size_t view = 0; view < map.view_count(); ++view)
        map.draw(view, objects);
    return map;
}

std::size_t most_bytes(const std::vector<shading::Light<float>>& lights,
                       const ShadowMapRule& rule) {
    std::size_t views = 0;
    for (const auto& light : lights)
        views += view_count(light);
    const auto size = static_cast<std::size_t>(rule.size);
    return views * size * size * sizeof(raster::Depth);
}

}  // namespace scanlight::render
