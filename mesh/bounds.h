#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "mesh/mesh.h"

namespace scanlight::mesh {

/// An axis-aligned box; corners included. In double, because the size of a float box need not be a
/// float. Begins empty, and grows.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    bool empty() const { return low.x > high.x; }

    // Of a box that is not empty:
    glm::dvec3 center() const { return 0.5 * low + 0.5 * high; }
    glm::dvec3 size() const { return high - low; }
};

struct Ball {
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

/// The smallest box around the vertices, object space; a point at the origin for an empty mesh.
Box bounding_box(const Mesh& mesh);

/// The smallest ball about the centre of the bounding box that holds every vertex, object space.
/// Not the smallest of all, but one that looks centred in a picture.
Ball bounding_ball(const Mesh& mesh);

}  // namespace scanlight::mesh
