#include "render/texture_fit.h"

#include <algorithm>

#include <glm/mat3x3.hpp>

namespace scanlight::render {

namespace {

/// Turns the axis to z, and keeps the way round: rows of a rotation.
glm::dmat3 turned(Axis axis) {
    const glm::dvec3 x(1, 0, 0);
    const glm::dvec3 y(0, 1, 0);
    const glm::dvec3 z(0, 0, 1);
    switch (axis) {
        case Axis::x:
            return glm::transpose(glm::dmat3(y, z, x));
        case Axis::y:
            return glm::transpose(glm::dmat3(z, x, y));
        default:
            return glm::dmat3(1.0);
    }
}

glm::dmat4 affine(const glm::dmat3& linear, const glm::dvec3& shift) {
    glm::dmat4 m(linear);
    m[3] = glm::dvec4(shift, 1.0);
    return m;
}

/// Of a side of no length nothing is to be made.
glm::dvec3 inverse_or_one(const glm::dvec3& v) {
    const auto inverse = [](double x) { return x > 0.0 ? 1.0 / x : 1.0; };
    return {inverse(v.x), inverse(v.y), inverse(v.z)};
}

glm::dmat3 diagonal(const glm::dvec3& v) {
    return {{v.x, 0, 0}, {0, v.y, 0}, {0, 0, v.z}};
}

}  // namespace

shading::Texture fitted(shading::Texture texture, const mesh::Box& box, Axis axis, double scale) {
    using shading::Mapping;
    const glm::dmat3 turn = turned(axis);
    const glm::dvec3 sides = glm::abs(turn * box.size());
    const glm::dvec3 per_side = inverse_or_one(sides);
    const double longest = std::max({sides.x, sides.y, sides.z});
    glm::dvec3 stretch(scale);
    glm::dvec3 middle(0.0);
    if (shading::fills_space(texture.pattern)) {
        stretch *= inverse_or_one(glm::dvec3(0.5 * longest));
        // A box ends in the middle of a cube, not where rounding would decide between two.
        if (texture.pattern == shading::Pattern::solid_checker) middle = glm::dvec3(0.5);
    } else if (texture.mapping == Mapping::planar) {
        stretch *= per_side;
        middle = glm::dvec3(0.5);
    } else if (texture.mapping == Mapping::cylindrical ||
               texture.mapping == Mapping::chapter_cylinder) {
        stretch.z *= per_side.z;
        middle.z = 0.5;
    }
    const glm::dmat3 linear = diagonal(stretch) * turn;
    texture.texture_from_object = glm::mat4(affine(linear, middle - linear * box.center()));
    return texture;
}

}  // namespace scanlight::render
