#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/mesh.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Seeded random numbers that are the same everywhere.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    template <class T>
    void shuffle(std::vector<T>& items) {
        for (std::size_t i = items.size(); i > 1; --i) {
            std::swap(items[i - 1], items[below(static_cast<std::uint32_t>(i))]);
        }
    }

private:
    std::mt19937 engine_;
};

using Faces = std::vector<std::vector<std::uint32_t>>;

inline PolygonSoup soup_of(std::vector<glm::vec3> positions, const Faces& faces) {
    PolygonSoup soup;
    soup.positions = std::move(positions);
    for (const auto& face : faces) {
        for (const std::uint32_t point : face) {
            soup.corners.push_back({.position = point});
        }
        soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
    return soup;
}

inline PolygonSoup scaled(PolygonSoup soup, float scale) {
    for (glm::vec3& p : soup.positions) {
        p *= scale;
    }
    return soup;
}

inline std::vector<glm::vec3> points_of_face(const Mesh& mesh, std::size_t face) {
    std::vector<glm::vec3> points;
    for (const std::uint32_t vertex : mesh.face(face)) {
        points.push_back(mesh.vertices.position(vertex));
    }
    return points;
}

inline glm::dvec3 area_of(const std::vector<glm::vec3>& polygon) {
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin = polygon[0];
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        sum += glm::cross(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
    }
    return 0.5 * sum;
}

/// By the divergence theorem; positive when the faces of a closed mesh look outward.
inline double volume_of(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const std::vector<glm::vec3> points = points_of_face(mesh, face);
        for (std::size_t i = 1; i + 1 < points.size(); ++i) {
            sum += glm::dot(glm::dvec3(points[0]),
                            glm::cross(glm::dvec3(points[i]), glm::dvec3(points[i + 1])));
        }
    }
    return sum / 6.0;
}

inline bool is_unit(const glm::vec3& n) {
    return std::abs(glm::length(n) - 1.0f) < 1e-6f;
}

inline bool all_normals_are_unit(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (!is_unit(mesh.vertices.normal(i))) return false;
    }
    for (const glm::vec3& n : mesh.face_normals) {
        if (!is_unit(n)) return false;
    }
    return true;
}

/// The largest difference of a coordinate.
inline float distance(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

}  // namespace scanlight::mesh
