#include "render/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "mesh/bounds.h"
#include "mesh/trigonometry.h"

namespace scanlight::render {

namespace {

using mesh::Box;

constexpr double margin = 1.06;  // room between the objects and the picture's border

/// Calls `visit(position)` for each vertex of each object, in world space.
template <class Visit>
void for_each_point(const std::vector<Object>& objects, Visit&& visit) {
    for (const Object& object : objects) {
        const auto& vertices = object.mesh->vertices;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            visit(glm::dvec3(object.world_from_object *
                             glm::dvec4(glm::dvec3(vertices.position(i)), 1.0)));
        }
    }
}

Box box_of(const std::vector<Object>& objects) {
    Box box;
    for_each_point(objects, [&](const glm::dvec3& p) { box.include(p); });
    return box;
}

Box box_in_eye_space(const Camera& camera, const std::vector<Object>& objects) {
    const glm::dmat4 view = eye_from_world(camera);
    Box box;
    for_each_point(objects, [&](const glm::dvec3& p) { box.include(view * glm::dvec4(p, 1.0)); });
    return box;
}

double length(const glm::dvec3& v) {
    return std::sqrt(glm::dot(v, v));
}

/// The diagonal; of a single point what can be told from nothing beside its coordinates.
double size_of(const Box& box) {
    const double reach = std::max(length(box.low), length(box.high));
    return std::max({length(box.size()), 1e-6 * reach, 1e-30});
}

/// The axis of the view, backwards.
glm::dvec3 towards_eye(const Camera& camera) {
    const glm::dmat4 view = eye_from_world(camera);
    return {view[0][2], view[1][2], view[2][2]};
}

/// The objects' points as the camera sees them from its target: x to the right, y up, z towards it.
std::vector<glm::dvec3> points_before(const Camera& camera, const std::vector<Object>& objects) {
    const glm::dmat3 eye_axes(eye_from_world(camera));
    std::vector<glm::dvec3> points;
    for_each_point(objects,
                   [&](const glm::dvec3& p) { points.push_back(eye_axes * (p - camera.target)); });
    return points;
}

Camera moved(Camera camera, const glm::dvec3& target, double distance) {
    const glm::dvec3 backwards = towards_eye(camera);
    camera.target += glm::transpose(glm::dmat3(eye_from_world(camera))) * target;
    camera.eye = camera.target + backwards * distance;
    return camera;
}

/// Where a perspective camera must stand, seen from the side, for the borders of its picture to
/// touch the objects on both sides.
struct Stand {
    double distance;  // before the target's plane
    double place;     // along the axis of the picture
    double width;     // from the one point touched to the other, along that axis
};

/// From the distance d and the place c a point is in the picture if slope |y - c| <= d - z. Both
/// of the borders touch where d = max(z + slope y) - slope c = max(z - slope y) + slope c.
Stand stand_for(const std::vector<glm::dvec3>& points, int axis, double slope) {
    double above = std::numeric_limits<double>::lowest();
    double below = above;
    double highest = 0.0;
    double lowest = 0.0;
    for (const glm::dvec3& p : points) {
        const double rise = slope * p[axis];
        if (p.z + rise > above) {
            above = p.z + rise;
            highest = p[axis];
        }
        if (p.z - rise > below) {
            below = p.z - rise;
            lowest = p[axis];
        }
    }
    return {0.5 * (above + below), 0.5 * (above - below) / slope, highest - lowest};
}

/// The place from which the objects are in the middle along an axis, at a distance that leaves them
/// room: that of the narrower picture which they would fill. Its slope is found by Newton's method;
/// the distance is a convex chain of straight pieces over the slope, so few steps are exact.
double middle_from(double distance, const std::vector<glm::dvec3>& points, int axis, double slope) {
    constexpr int steps = 24;
    constexpr double enough = 1e-9;
    Stand stand = stand_for(points, axis, slope);
    for (int i = 0; i < steps; ++i) {
        const double missing = distance - stand.distance;
        if (std::abs(missing) <= enough * distance) break;
        // While one point, a tip, is touched on both sides the chain is level.
        slope = stand.width > 0.0 ? slope + missing / (0.5 * stand.width) : 2.0 * slope;
        stand = stand_for(points, axis, slope);
    }
    return stand.place;
}

Camera framed_in_perspective(const Camera& camera, const std::vector<Object>& objects,
                             double aspect, double size) {
    const auto points = points_before(camera, objects);
    const double slope_y = margin * camera.magnification;
    const double slope_x = slope_y / aspect;
    const double room = 1e-3 * size;  // between the eye and a spike towards it
    double distance =
        std::max(stand_for(points, 0, slope_x).distance, stand_for(points, 1, slope_y).distance);
    for (const glm::dvec3& p : points)
        distance = std::max(distance, p.z + room);
    const double x = middle_from(distance, points, 0, slope_x);
    const double y = middle_from(distance, points, 1, slope_y);
    return moved(camera, {x, y, 0.0}, distance);
}

Camera framed_in_parallel(Camera camera, const std::vector<Object>& objects, double aspect,
                          double size) {
    Box seen;
    for (const glm::dvec3& p : points_before(camera, objects))
        seen.include(p);
    const glm::dvec3 half = 0.5 * seen.size();
    const glm::dvec3 middle = seen.center();
    camera = moved(camera, {middle.x, middle.y, 0.0}, 2.0 * size);
    camera.magnification = 1.0 / (margin * std::max({half.x / aspect, half.y, 1e-30}));
    return camera;
}

}  // namespace

glm::dvec3 direction_of(const ViewAngles& angles) {
    const double azimuth = angles.azimuth_deg * mesh::pi / 180.0;
    const double elevation = angles.elevation_deg * mesh::pi / 180.0;
    const double level = mesh::cosine(elevation);
    return {level * mesh::sine(azimuth), mesh::sine(elevation), level * mesh::cosine(azimuth)};
}

Camera framed(Camera camera, const std::vector<Object>& objects, double aspect) {
    const Box box = box_of(objects);
    if (box.empty()) return camera;
    const double size = size_of(box);
    const glm::dvec3 direction = towards_eye(camera);
    camera.target = box.center();
    camera.eye = camera.target + direction * (2.0 * size);
    camera = camera.projection == Projection::perspective
                 ? framed_in_perspective(camera, objects, aspect, size)
                 : framed_in_parallel(camera, objects, aspect, size);
    return with_fitted_planes(camera, objects);
}

Camera with_fitted_planes(Camera camera, const std::vector<Object>& objects) {
    const Box box = box_in_eye_space(camera, objects);
    if (box.empty()) return camera;
    const double slack = 1e-3 * (box.high.z - box.low.z) + 1e-6 * std::abs(box.low.z);
    const double nearest = -box.high.z - slack;
    const double farthest = -box.low.z + slack;
    if (camera.projection == Projection::orthographic) {
        camera.near = nearest;
        camera.far = std::max(farthest, nearest + 1e-30);
    } else if (farthest > 0.0) {
        camera.far = farthest;
        camera.near = std::max(nearest, 1e-4 * farthest);
    }
    return camera;
}

Camera with_room_for_shadows(Camera camera) {
    // Infinity lies far / (far - near) times as deep as the far plane: 4/3, less than
    // `deepest_ndc`.
    if (camera.projection == Projection::perspective)
        camera.near = std::min(camera.near, 0.25 * camera.far);
    return camera;
}

}  // namespace scanlight::render
