// The room's functions on a vector of lanes give each lane the bits that it has alone. This small
// type stands for the SIMD types; it shows all that such a type has to bring.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shading/illumination.h"
#include "tests/shading/random.h"

namespace scanlight::shading {
namespace {

constexpr int lane_count = 4;

struct Mask {
    std::array<bool, lane_count> lane;
};

struct Lanes {
    std::array<float, lane_count> lane;

    Lanes() = default;
    explicit Lanes(float value) { lane.fill(value); }
    explicit Lanes(double value) : Lanes(static_cast<float>(value)) {}
    explicit Lanes(int value) : Lanes(static_cast<float>(value)) {}
};

template <class Result, class Operation>
Result each_lane(Operation operation) {
    Result result;
    for (std::size_t i = 0; i < lane_count; ++i)
        result.lane[i] = operation(i);
    return result;
}

#define LANES_OPERATOR(Result, op)                                                \
    Result operator op(const Lanes& a, const Lanes& b) {                          \
        return each_lane<Result>([&](auto i) { return a.lane[i] op b.lane[i]; }); \
    }
LANES_OPERATOR(Lanes, +)
LANES_OPERATOR(Lanes, -)
LANES_OPERATOR(Lanes, *)
LANES_OPERATOR(Lanes, /)
LANES_OPERATOR(Mask, <)
LANES_OPERATOR(Mask, >)
LANES_OPERATOR(Mask, <=)
LANES_OPERATOR(Mask, >=)
#undef LANES_OPERATOR

Mask operator&(const Mask& a, const Mask& b) {
    return each_lane<Mask>([&](auto i) { return a.lane[i] && b.lane[i]; });
}

bool none(const Mask& mask) {
    return std::ranges::none_of(mask.lane, [](bool has) { return has; });
}

Lanes operator-(const Lanes& a) {
    return each_lane<Lanes>([&](auto i) { return -a.lane[i]; });
}

Lanes select(const Mask& condition, const Lanes& yes, const Lanes& no) {
    return each_lane<Lanes>([&](auto i) { return condition.lane[i] ? yes.lane[i] : no.lane[i]; });
}

Lanes sqrt(const Lanes& x) {
    return each_lane<Lanes>([&](auto i) { return std::sqrt(x.lane[i]); });
}

Lanes nearest_whole(const Lanes& x) {
    return each_lane<Lanes>([&](auto i) { return shading::nearest_whole(x.lane[i]); });
}

Lanes power_of_two(const Lanes& exponent) {
    return each_lane<Lanes>([&](auto i) { return shading::power_of_two(exponent.lane[i]); });
}

Split<Lanes> split(const Lanes& x) {
    return {each_lane<Lanes>([&](auto i) { return shading::split(x.lane[i]).mantissa; }),
            each_lane<Lanes>([&](auto i) { return shading::split(x.lane[i]).exponent; })};
}

}  // namespace

template <>
struct Format<Lanes> : Format<float> {};

namespace {

Vec3<Lanes> gather(const std::array<Vec3<float>, lane_count>& vectors) {
    return {each_lane<Lanes>([&](auto i) { return vectors[i].x; }),
            each_lane<Lanes>([&](auto i) { return vectors[i].y; }),
            each_lane<Lanes>([&](auto i) { return vectors[i].z; })};
}

Vec3<float> lane_of(const Vec3<Lanes>& v, std::size_t i) {
    return {v.x.lane[i], v.y.lane[i], v.z.lane[i]};
}

struct Batch {
    std::array<Vec3<float>, lane_count> points, normals, views;

    Surface<float> surface(std::size_t i) const { return {points[i], normals[i], views[i]}; }
    Surface<Lanes> surfaces() const { return {gather(points), gather(normals), gather(views)}; }
};

Batch random_batch(Random& random) {
    Batch batch;
    for (std::size_t i = 0; i < lane_count; ++i) {
        batch.points[i] = Vec3<float>(random.in_cube(3));
        batch.normals[i] = Vec3<float>(random.unit_vector());
        batch.views[i] = Vec3<float>(random.unit_vector());
    }
    return batch;
}

Lighting<float> random_lighting(Random& random, Falloff falloff) {
    const Rgb<float> ambient(random.color());
    const Vec3<float> towards(random.unit_vector());
    const Vec3<float> position(random.in_cube(3));
    return {ambient,
            {directional_light(towards, Rgb<float>(random.color())),
             point_light(position, Rgb<float>(random.color()), {.falloff = falloff})}};
}

template <class Model>
void expect_lanes_equal_scalars(const Batch& batch, const Material<float>& material,
                                const Lighting<float>& lighting) {
    const Rgb<Lanes> together =
        illuminate<Model>(facing_viewer(batch.surfaces()), material, lighting);
    for (std::size_t i = 0; i < lane_count; ++i) {
        const Rgb<float> alone =
            illuminate<Model>(facing_viewer(batch.surface(i)), material, lighting);
        ASSERT_EQ(lane_of(together, i), alone);
    }
}

/// Of all distributions and all kinds of reflectance.
Microfacets random_facets(Random& random, int i) {
    constexpr FacetDistribution distributions[] = {
        FacetDistribution::beckmann, FacetDistribution::gauss, FacetDistribution::cosine};
    const Reflectance materials[] = {dielectric(1.5), metal({0.2, 0.6, 1.4}, {3.3, 2.1, 1.9}),
                                     shifted(metal_of_color({0.9, 0.6, 0.4}))};
    const double m = random.between(0.05, 0.7);
    return {{distributions[i % 3], m}, materials[i / 3 % 3], random.between(0, 1)};
}

Transmission<float> random_transmission(Random& random, double n) {
    const Rgb<float> diffuse(random.color());
    const Rgb<float> specular(random.color());
    return {diffuse, specular, n, random.between(0, 1) < 0.2 ? 1 : random.between(0.5, 2)};
}

TEST(Lanes, HaveTheBitsOfTheScalars) {
    Random random(1);
    for (const double n : {0.0, 1.0, 20.0, 96.078431}) {
        for (const Falloff falloff : {Falloff::constant, Falloff::inverse, Falloff::inverse_square,
                                      Falloff::inverse_plus_k}) {
            for (int i = 0; i < 200; ++i) {
                const Batch batch = random_batch(random);
                const Material<float> material{.specular = Rgb<float>(0.5f),
                                               .exponent = n,
                                               .transmission = random_transmission(random, n),
                                               .facets = random_facets(random, i)};
                const Lighting<float> lighting = random_lighting(random, falloff);
                expect_lanes_equal_scalars<Lambert>(batch, material, lighting);
                expect_lanes_equal_scalars<Gouraud1971>(batch, material, lighting);
                expect_lanes_equal_scalars<Phong>(batch, material, lighting);
                expect_lanes_equal_scalars<Blinn>(batch, material, lighting);
                expect_lanes_equal_scalars<Hall>(batch, material, lighting);
                expect_lanes_equal_scalars<CookTorrance>(batch, material, lighting);
            }
        }
    }
}

}  // namespace
}  // namespace scanlight::shading
