#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/clip.h"
#include "raster/project.h"
#include "tests/raster/filled.h"

// Clipping leaves the parts of a concave polygon joined by bridges along the plane. They must not
// be seen: neither a pixel in the gap between two parts, nor a hole in one.

namespace scanlight::raster {
namespace {

using laws::Counter;
using laws::Counts;
using laws::Points;
using laws::Random;

constexpr int size = 64;
constexpr double near_distance = 1.0;
constexpr double far_distance = 3.0;

/// A star on a plane in eye space, seen under 90 degrees; it looks down -z.
struct Star {
    Points corners;  // on the plane, within [0, extent]
    glm::dvec3 centre, across, along;

    static constexpr int extent = 1024;

    glm::dvec2 on_plane(ScreenPoint p) const {
        return {p.x / (0.5 * extent) - 1.0, p.y / (0.5 * extent) - 1.0};
    }
    glm::dvec3 in_space(const glm::dvec2& p) const { return centre + p.x * across + p.y * along; }
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const glm::dvec3& a, const glm::dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Long arms about the middle of the square.
Points long_arms(Random& random) {
    constexpr int half = Star::extent / 2;
    constexpr std::array<std::array<int, 2>, 12> twelfths{{{12, 0},
                                                           {10, 6},
                                                           {6, 10},
                                                           {0, 12},
                                                           {-6, 10},
                                                           {-10, 6},
                                                           {-12, 0},
                                                           {-10, -6},
                                                           {-6, -10},
                                                           {0, -12},
                                                           {6, -10},
                                                           {10, -6}}};
    Points points;
    for (std::size_t i = 0; i < twelfths.size(); ++i) {
        const int length = i % 2 == 0 ? random.between(half / 2, half) : random.between(20, 120);
        points.push_back(
            {half + twelfths[i][0] * length / 12, half + twelfths[i][1] * length / 12});
    }
    return points;
}

/// One that reaches through the near plane or the far plane, as well as beyond the picture.
Star random_star(Random& random) {
    const auto about = [&random](double middle, double range) {
        return middle + range * static_cast<double>(random.real(-1.0f, 1.0f));
    };
    Star star;
    star.corners = random.one_in(2) ? long_arms(random) : laws::random_star(random, Star::extent);
    const double distance = random.one_in(2) ? near_distance : far_distance;
    const double width = distance * about(0.9, 0.3);
    const double turn = about(0.0, 1.0);
    const double other = std::sqrt(1.0 - turn * turn);
    const double tilt = distance * about(0.4, 0.2);
    star.centre = {0.0, 0.0, -distance + about(0.0, 0.6 * tilt)};
    star.across = {width * other, 0.0, tilt * turn};
    star.along = {0.0, width * turn, tilt * other};
    return star;
}

ClipVertex<0> projected(const glm::dvec3& p) {
    constexpr double range = far_distance - near_distance;
    const double z = (-p.z - near_distance) * far_distance / range;
    return {glm::vec4(glm::dvec4(p.x, p.y, z, -p.z)), {}};
}

Counts filled(Counter& counter, const std::vector<std::vector<ClipVertex<0>>>& polygons) {
    Counts counts = laws::no_counts(size);
    for (const auto& polygon : polygons)
        counter.add(project_affine(clip(polygon), {size, size}), counts);
    return counts;
}

std::vector<ClipVertex<0>> whole(const Star& star) {
    std::vector<ClipVertex<0>> polygon;
    for (const ScreenPoint p : star.corners)
        polygon.push_back(projected(star.in_space(star.on_plane(p))));
    return polygon;
}

/// All of its boundary is seen from the middle: a fan of triangles.
std::vector<std::vector<ClipVertex<0>>> triangulated(const Star& star) {
    const auto corners = whole(star);
    std::vector<std::vector<ClipVertex<0>>> triangles;
    for (std::size_t i = 0; i < corners.size(); ++i)
        triangles.push_back(
            {projected(star.centre), corners[i], corners[(i + 1) % corners.size()]});
    return triangles;
}

bool contains(const Star& star, const glm::dvec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < star.corners.size(); ++i) {
        const glm::dvec2 a = star.on_plane(star.corners[i]);
        const glm::dvec2 b = star.on_plane(star.corners[(i + 1) % star.corners.size()]);
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        const bool beside = (cross(b - a, p - a) > 0.0) == (b.y > a.y);
        if (beside) inside = !inside;
    }
    return inside;
}

/// Whether the star is to be seen at a place of the picture, by the ray through it.
bool seen_at(const Star& star, double x, double y) {
    const glm::dvec3 ray(2.0 * x / size - 1.0, 1.0 - 2.0 * y / size, -1.0);
    const glm::dvec3 normal = cross(star.across, star.along);
    const double distance = dot(star.centre, normal) / dot(ray, normal);
    if (!(distance >= near_distance && distance <= far_distance)) return false;
    const glm::dvec3 from_centre = distance * ray - star.centre;
    const double area = dot(normal, normal);
    return contains(star, {dot(cross(from_centre, star.along), normal) / area,
                           dot(cross(star.across, from_centre), normal) / area});
}

/// None within 1/128 pixel of an outline, looked for in steps of 1/512: corners are snapped to
/// 1/256.
std::optional<int> expected_at(const Star& star, int column, int row) {
    const bool seen = seen_at(star, column + 0.5, row + 0.5);
    for (int dy = -4; dy <= 4; ++dy) {
        for (int dx = -4; dx <= 4; ++dx) {
            if (seen_at(star, column + 0.5 + dx / 512.0, row + 0.5 + dy / 512.0) != seen)
                return std::nullopt;
        }
    }
    return seen ? 1 : 0;
}

TEST(ClipConcave, AStarCoversWhatItsTrianglesCover) {
    Random random(1);
    Counter counter;
    int cut = 0;
    for (int i = 0; i < laws::cases(20'000); ++i) {
        const Star star = random_star(random);
        const Counts as_whole = filled(counter, {whole(star)});
        const Counts as_parts = filled(counter, triangulated(star));
        cut += clip(whole(star)).size() > star.corners.size() + 2 ? 1 : 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                if (as_whole.at(x, y) == as_parts.at(x, y)) continue;
                const auto expected = expected_at(star, x, y);
                ASSERT_FALSE(expected.has_value())
                    << "whole " << as_whole.at(x, y) << ", parts " << as_parts.at(x, y)
                    << ", expected " << *expected << " at " << x << ", " << y << " of star " << i;
            }
        }
    }
    EXPECT_GT(cut, laws::cases(20'000) / 25);
}

TEST(ClipConcave, AStarCoversWhatIsSeenOfIt) {
    Random random(2);
    Counter counter;
    for (int i = 0; i < laws::cases(100); ++i) {
        const Star star = random_star(random);
        const Counts counts = filled(counter, {whole(star)});
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const auto expected = expected_at(star, x, y);
                if (!expected) continue;
                ASSERT_EQ(counts.at(x, y), *expected) << x << ", " << y << " of star " << i;
            }
        }
    }
}

}  // namespace
}  // namespace scanlight::raster
