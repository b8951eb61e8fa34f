#include "mesh/newell.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scanlight::mesh {
namespace {

/// A sum of cross products, with the sum of the magnitudes of their terms: its rounding error is in
/// proportion to the latter.
struct CrossSum {
    glm::dvec3 value{0.0};
    glm::dvec3 magnitude{0.0};

    void add(const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 plus(a.y * b.z, a.z * b.x, a.x * b.y);
        const glm::dvec3 minus(a.z * b.y, a.x * b.z, a.y * b.x);
        value += plus - minus;
        magnitude += glm::abs(plus) + glm::abs(minus);
    }

    /// Nothing but rounding error: the smallest true area of points with 24-bit coordinates of one
    /// scale is 2^-50 of the magnitude.
    bool vanishes() const {
        const glm::dvec3 error = 0x1p-51 * magnitude;
        const glm::dvec3 size = glm::abs(value);
        return size.x <= error.x && size.y <= error.y && size.z <= error.z;
    }
};

CrossSum fan_triangle(std::span<const glm::vec3> polygon, std::size_t i) {
    const glm::dvec3 origin = polygon[0];
    CrossSum triangle;
    triangle.add(glm::dvec3(polygon[i]) - origin, glm::dvec3(polygon[i + 1]) - origin);
    return triangle;
}

CrossSum fan(std::span<const glm::vec3> polygon) {
    const glm::dvec3 origin = polygon[0];
    CrossSum sum;
    glm::dvec3 spoke = glm::dvec3(polygon[1]) - origin;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const glm::dvec3 next = glm::dvec3(polygon[i]) - origin;
        sum.add(spoke, next);
        spoke = next;
    }
    return sum;
}

glm::dvec3 largest_triangle(std::span<const glm::vec3> polygon) {
    glm::dvec3 largest(0.0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const CrossSum triangle = fan_triangle(polygon, i);
        const bool larger = glm::dot(triangle.value, triangle.value) > glm::dot(largest, largest);
        if (larger && !triangle.vanishes()) largest = triangle.value;
    }
    return largest;
}

}  // namespace

glm::dvec3 area_vector(std::span<const glm::vec3> polygon) {
    if (polygon.size() < 3) return glm::dvec3(0.0);
    const CrossSum sum = fan(polygon);
    return 0.5 * (sum.vanishes() ? largest_triangle(polygon) : sum.value);
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : v;
}

}  // namespace scanlight::mesh
