#include "render/face_shadow.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/triangulate.h"
#include "render/transform.h"

namespace scanlight::render {

namespace {

using Polygon = FaceShadow::Polygon;

glm::dvec3 area_vector(std::span<const glm::dvec3> face) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += glm::cross(face[i - 1] - face[0], face[i] - face[0]);
    return sum;
}

/// From a point to the light.
glm::dvec3 towards(const glm::dvec4& light, const glm::dvec3& point) {
    return glm::dvec3(light) - light.w * point;
}

}  // namespace

double FaceShadow::Plane::distance(const glm::dvec3& point) const {
    return glm::dot(normal, point) - offset;
}

FaceShadow::FaceShadow(std::span<const glm::dvec3> face, const glm::dvec4& light) {
    const auto add = [this](const glm::dvec3& inwards, const glm::dvec3& point) {
        const glm::dvec3 normal = glm::normalize(inwards);
        planes_.push_back({normal, glm::dot(normal, point)});
    };
    const glm::dvec3 up = area_vector(face);
    const double side = glm::dot(up, towards(light, face[0]));
    if (!(side != 0.0)) return;
    const double sign = side > 0.0 ? 1.0 : -1.0;
    add(-sign * up, face[0]);
    for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3& a = face[i];
        const glm::dvec3& b = face[(i + 1) % face.size()];
        add(sign * glm::cross(towards(light, a), b - a), a);
    }
}

bool FaceShadow::contains(const glm::dvec3& point, double tolerance) const {
    if (empty() || !(behind(point) > tolerance)) return false;
    return std::ranges::all_of(std::span(planes_).subspan(1),
                               [&](const Plane& plane) { return plane.distance(point) >= 0.0; });
}

Polygon FaceShadow::clipped(const Polygon& polygon, const Plane& plane, double sign) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double at_a = sign * plane.distance(a);
        const double at_b = sign * plane.distance(b);
        if (at_a >= 0.0) result.push_back(a);
        if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0))
            result.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return result;
}

FaceShadow::Parts FaceShadow::cut(Polygon polygon) const {
    Parts parts;
    if (empty()) return {{}, {std::move(polygon)}};
    for (const Plane& plane : planes_) {
        Polygon outside = clipped(polygon, plane, -1.0);
        if (outside.size() >= 3) parts.lit.push_back(std::move(outside));
        polygon = clipped(polygon, plane, 1.0);
    }
    if (polygon.size() >= 3) parts.shadowed = std::move(polygon);
    return parts;
}

std::vector<FaceShadow> face_shadows(const std::vector<Object>& objects, const glm::dvec4& light) {
    std::vector<FaceShadow> shadows;
    for (const Object& object : objects) {
        const mesh::Mesh triangles = mesh::triangulated(*object.mesh);
        for (std::size_t f = 0; f < triangles.face_count(); ++f) {
            Polygon corners;
            for (const std::uint32_t v : triangles.face(f)) {
                corners.emplace_back(transformed_point(object.world_from_object,
                                                       glm::dvec3(triangles.vertices.position(v))));
            }
            shadows.emplace_back(corners, light);
        }
    }
    return shadows;
}

}  // namespace scanlight::render
