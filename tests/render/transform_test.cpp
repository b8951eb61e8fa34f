#include "render/transform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "render/viewing.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

/// The least that a vector of lanes brings; it stands for the SIMD types.
template <class Number>
struct Pair {
    std::array<Number, 2> lane;

    Pair() = default;
    template <class Other>
    requires std::is_arithmetic_v<Other>
    explicit Pair(Other value) { lane.fill(static_cast<Number>(value)); }
    Pair(Number first, Number second) : lane{first, second} {}
};

struct Both {
    bool first, second;
    friend Both operator&(Both a, Both b) { return {a.first && b.first, a.second && b.second}; }
};

template <class Number>
Pair<Number> operator+(const Pair<Number>& a, const Pair<Number>& b) {
    return {a.lane[0] + b.lane[0], a.lane[1] + b.lane[1]};
}
template <class Number>
Pair<Number> operator-(const Pair<Number>& a, const Pair<Number>& b) {
    return {a.lane[0] - b.lane[0], a.lane[1] - b.lane[1]};
}
template <class Number>
Pair<Number> operator*(const Pair<Number>& a, const Pair<Number>& b) {
    return {a.lane[0] * b.lane[0], a.lane[1] * b.lane[1]};
}
template <class Number>
Pair<Number> operator/(const Pair<Number>& a, const Pair<Number>& b) {
    return {a.lane[0] / b.lane[0], a.lane[1] / b.lane[1]};
}
template <class Number>
Both operator>=(const Pair<Number>& a, const Pair<Number>& b) {
    return {a.lane[0] >= b.lane[0], a.lane[1] >= b.lane[1]};
}
template <class Number>
Both operator<=(const Pair<Number>& a, const Pair<Number>& b) {
    return {a.lane[0] <= b.lane[0], a.lane[1] <= b.lane[1]};
}
template <class Number>
Pair<Number> select(Both condition, const Pair<Number>& yes, const Pair<Number>& no) {
    return {condition.first ? yes.lane[0] : no.lane[0],
            condition.second ? yes.lane[1] : no.lane[1]};
}
template <class Number>
Pair<Number> sqrt(const Pair<Number>& x) {
    return {std::sqrt(x.lane[0]), std::sqrt(x.lane[1])};
}

template <class Number>
using Vec3 = shading::Vec3<Number>;

template <class Number>
Vec3<Pair<Number>> paired(const Vec3<Number>& a, const Vec3<Number>& b) {
    return {Pair<Number>(a.x, b.x), Pair<Number>(a.y, b.y), Pair<Number>(a.z, b.z)};
}

template <int components, class Number>
glm::vec<components, Number> lane_of(const glm::vec<components, Pair<Number>>& v, std::size_t i) {
    glm::vec<components, Number> result;
    for (int k = 0; k < components; ++k)
        result[k] = v[k].lane[i];
    return result;
}

glm::dmat4 random_matrix(Random& random) {
    glm::dmat4 m;
    for (int column = 0; column < 4; ++column) {
        const glm::dvec3 linear = random.in_cube(3.0);
        m[column] = glm::dvec4(linear, random.between(-3.0, 3.0));
    }
    return m;
}

TEST(Transform, IsTheMatrixsProductToTheBit) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::dmat4 m = random_matrix(random);
        const glm::dvec3 p = random.in_cube(100.0);
        EXPECT_EQ(transformed_point(m, p), m * glm::dvec4(p, 1.0));
    }
}

TEST(Transform, LanesHaveTheBitsOfTheScalars) {
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const glm::dmat4 m = random_matrix(random);
        const glm::mat3 normals(m);
        const std::array<glm::dvec3, 2> p{random.in_cube(100.0), random.in_cube(100.0)};
        const std::array<glm::vec3, 2> n{random.direction(), random.direction()};
        const auto points = transformed_point(m, paired(p[0], p[1]));
        const auto turned = transformed_normal(normals, paired(n[0], n[1]));
        for (const std::size_t lane : {0u, 1u}) {
            EXPECT_EQ(lane_of(points, lane), transformed_point(m, p[lane]));
            EXPECT_EQ(lane_of(turned, lane), transformed_normal(normals, n[lane]));
        }
    }
}

TEST(Transform, LanesGoBackIntoTheWorldByTheBitsOfTheScalars) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const glm::mat4 world_from_screen(random_matrix(random));
        const glm::vec4 viewpoint(glm::vec3(random.in_cube(9.0)), i % 2 == 0 ? 1.0f : 0.0f);
        const std::array<glm::vec3, 2> screen{random.in_cube(100.0), random.in_cube(100.0)};
        const auto points = point_behind(world_from_screen, paired(screen[0], screen[1]));
        const auto views = view_from(viewpoint, points);
        const SightRow row{screen[0], screen[1]};
        const auto along = view_along(row, points.x);
        for (const std::size_t lane : {0u, 1u}) {
            const glm::vec3 point = point_behind(world_from_screen, screen[lane]);
            EXPECT_EQ(lane_of(points, lane), point);
            EXPECT_EQ(lane_of(views, lane), view_from(viewpoint, point));
            EXPECT_EQ(lane_of(along, lane), view_along(row, point.x));
        }
    }
}

}  // namespace
}  // namespace scanlight::render
