#include "render/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "mesh/trigonometry.h"

namespace scanlight::render {

namespace {

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

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};

    void include(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    bool empty() const { return low.x > high.x; }
    glm::dvec3 centre() const { return 0.5 * (low + high); }
};

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
    return std::max({length(box.high - box.low), 1e-6 * reach, 1e-30});
}

/// The axis of the view, backwards.
glm::dvec3 towards_eye(const Camera& camera) {
    const glm::dmat4 view = eye_from_world(camera);
    return {view[0][2], view[1][2], view[2][2]};
}

/// What the objects take of the picture, in units of its half height: by a perspective camera at
/// z = -1, by an orthographic one as they are.
Box box_in_picture(const Camera& camera, const std::vector<Object>& objects) {
    const glm::dmat4 view = eye_from_world(camera);
    const bool perspective = camera.projection == Projection::perspective;
    Box box;
    for_each_point(objects, [&](const glm::dvec3& p) {
        const glm::dvec4 e = view * glm::dvec4(p, 1.0);
        const double scale = perspective ? 1.0 / std::max(-e.z, 1e-30) : 1.0;
        box.include({e.x * scale, e.y * scale, e.z});
    });
    return box;
}

/// Moves the camera sideways, so that the objects stand in the middle of the picture.
Camera centred(Camera camera, const std::vector<Object>& objects) {
    const glm::dvec3 off = box_in_picture(camera, objects).centre();
    const double distance =
        camera.projection == Projection::perspective ? length(camera.eye - camera.target) : 1.0;
    const glm::dmat4 view = eye_from_world(camera);
    const glm::dvec3 right(view[0][0], view[1][0], view[2][0]);
    const glm::dvec3 up(view[0][1], view[1][1], view[2][1]);
    const glm::dvec3 shift = (off.x * right + off.y * up) * distance;
    camera.eye += shift;
    camera.target += shift;
    return camera;
}

/// The smallest distance from which a perspective camera sees all: a point at height y and z before
/// the target's plane needs d >= z + m |y|, and some room before the eye.
Camera at_fitting_distance(Camera camera, const std::vector<Object>& objects, double aspect,
                           double size) {
    const double room = 1e-3 * size;
    const glm::dmat4 view = eye_from_world(camera);
    const double target_z = (view * glm::dvec4(camera.target, 1.0)).z;
    double distance = 0.0;
    for_each_point(objects, [&](const glm::dvec3& p) {
        const glm::dvec4 e = view * glm::dvec4(p, 1.0);
        const double reach = std::max(std::abs(e.x) / aspect, std::abs(e.y));
        const double needed = std::max(margin * camera.magnification * reach, room);
        distance = std::max(distance, e.z - target_z + needed);
    });
    camera.eye = camera.target + towards_eye(camera) * distance;
    return camera;
}

Camera framed_in_perspective(Camera camera, const std::vector<Object>& objects, double aspect,
                             double size) {
    constexpr int rounds = 4;  // the middle moves with the distance; it settles at once
    for (int i = 0; i < rounds; ++i) {
        camera = centred(at_fitting_distance(camera, objects, aspect, size), objects);
    }
    return at_fitting_distance(camera, objects, aspect, size);
}

Camera framed_in_parallel(Camera camera, const std::vector<Object>& objects, double aspect) {
    camera = centred(camera, objects);
    const Box seen = box_in_picture(camera, objects);
    const glm::dvec3 half = 0.5 * (seen.high - seen.low);
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
    camera.target = box.centre();
    camera.eye = camera.target + direction * (2.0 * size);
    camera = camera.projection == Projection::perspective
                 ? framed_in_perspective(camera, objects, aspect, size)
                 : framed_in_parallel(camera, objects, aspect);
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

}  // namespace scanlight::render
