#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/scene.h"

namespace scanlight::render {

using Corners = std::vector<glm::dvec3>;  // of a polygon, world space

/// A plane in world space.
struct OrientedPlane {
    glm::dvec3 normal{0.0};  // unit
    double offset = 0.0;

    /// Before it on the normal's side, in world units.
    double distance(const glm::dvec3& point) const;
};

/// A face as flat polygons: itself, or its triangles where it is bent.
struct FlatFace {
    std::size_t object = 0;  // its place in the scene
    std::size_t face = 0;    // of the object's mesh
    Corners corners;
    std::vector<Corners> polygons;
};

/// How far from a plane points of the objects may lie that are meant to be in it: some roundings of
/// a float at the largest coordinate.
double flatness(const std::vector<Object>& objects);

/// All faces of all objects, in their order.
std::vector<FlatFace> flat_faces(const std::vector<Object>& objects, double flatness);

/// Through a polygon, in the direction of its area vector; the normal is 0 if it has no area.
OrientedPlane plane_of(const Corners& polygon);

/// Half the length of the area vector.
double area_of(const Corners& polygon);

}  // namespace scanlight::render
