#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/scene.h"

namespace scanlight::render {

/// The shadow volume of one convex face in object space (Crow 1977): a half-open polyhedron, behind
/// the face as the light sees it, and inside the planes through the light and each of its edges.
/// Slow and plain: the reference of the other methods. World space.
class FaceShadow {
public:
    using Polygon = std::vector<glm::dvec3>;

    /// `light` is homogeneous: a place, or a direction towards it.
    FaceShadow(std::span<const glm::dvec3> face, const glm::dvec4& light);

    /// Nothing, where the light lies in the face's plane.
    bool empty() const { return planes_.empty(); }

    /// How far behind the face's plane a point lies, as the light sees it: in world units, negative
    /// before it. Of a shadow that is not empty.
    double behind(const glm::dvec3& point) const { return planes_.front().distance(point); }

    /// Farther behind the face than `tolerance`, in world units, which keeps a face from shadowing
    /// itself.
    bool contains(const glm::dvec3& point, double tolerance) const;

    /// The chapter's Boolean intersection: the part of a convex polygon in the shadow, and the rest
    /// of it in convex pieces. Each may be empty. Together they have the polygon's area.
    struct Parts {
        Polygon shadowed;
        std::vector<Polygon> lit;
    };
    Parts cut(Polygon polygon) const;

private:
    struct Plane {
        glm::dvec3 normal;  // unit, inwards
        double offset;

        double distance(const glm::dvec3& point) const;
    };

    static Polygon clipped(const Polygon& polygon, const Plane& plane, double sign);

    std::vector<Plane> planes_;  // the face's own, then those of its edges
};

/// The shadow volumes of all faces of some objects; those of more than three corners in triangles.
std::vector<FaceShadow> face_shadows(const std::vector<Object>& objects, const glm::dvec4& light);

}  // namespace scanlight::render
