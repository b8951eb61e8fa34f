#include "render/flat_polygons.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/ear_clipping.h"
#include "render/transform.h"

namespace scanlight::render {

namespace {

glm::dvec3 area_vector(const Corners& polygon) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return sum;
}

std::vector<glm::dvec3> placed_points(const Object& object) {
    const auto& vertices = object.mesh->vertices;
    std::vector<glm::dvec3> points;
    points.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        points.emplace_back(
            transformed_point(object.world_from_object, glm::dvec3(vertices.position(i))));
    }
    return points;
}

bool is_flat(const Corners& polygon, double flatness) {
    if (polygon.size() == 3) return true;
    const OrientedPlane plane = plane_of(polygon);
    return std::ranges::all_of(polygon, [&](const glm::dvec3& corner) {
        return std::abs(plane.distance(corner)) <= flatness;
    });
}

std::vector<Corners> triangles_of(const Object& object, std::size_t face, const Corners& corners) {
    std::vector<glm::vec3> positions;
    for (const std::uint32_t vertex : object.mesh->face(face))
        positions.push_back(object.mesh->vertices.position(vertex));
    std::vector<Corners> triangles;
    for (const auto& [a, b, c] : mesh::cut_ears(positions))
        triangles.push_back({corners[a], corners[b], corners[c]});
    return triangles;
}

}  // namespace

double OrientedPlane::distance(const glm::dvec3& point) const {
    return glm::dot(normal, point) - offset;
}

OrientedPlane plane_of(const Corners& polygon) {
    const glm::dvec3 area = area_vector(polygon);
    const double size = std::sqrt(glm::dot(area, area));
    if (!(size > 0.0)) return {};
    const glm::dvec3 normal = area / size;
    return {normal, glm::dot(normal, polygon.front())};
}

double area_of(const Corners& polygon) {
    const glm::dvec3 area = area_vector(polygon);
    return 0.5 * std::sqrt(glm::dot(area, area));
}

double flatness(const std::vector<Object>& objects) {
    constexpr double roundings = 0x1p-20;
    double reach = 0.0;
    for (const Object& object : objects) {
        for (const glm::dvec3& point : placed_points(object)) {
            const glm::dvec3 size = glm::abs(point);
            reach = std::max({reach, size.x, size.y, size.z});
        }
    }
    return roundings * reach;
}

std::vector<FlatFace> flat_faces(const std::vector<Object>& objects, double flatness) {
    std::vector<FlatFace> faces;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto points = placed_points(objects[i]);
        for (std::size_t f = 0; f < objects[i].mesh->face_count(); ++f) {
            FlatFace& face = faces.emplace_back(FlatFace{i, f, {}, {}});
            for (const std::uint32_t vertex : objects[i].mesh->face(f))
                face.corners.push_back(points[vertex]);
            face.polygons = is_flat(face.corners, flatness)
                                ? std::vector<Corners>{face.corners}
                                : triangles_of(objects[i], f, face.corners);
        }
    }
    return faces;
}

}  // namespace scanlight::render
