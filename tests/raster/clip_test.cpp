#include "raster/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "raster/project.h"
#include "tests/raster/cases.h"
#include "tests/raster/filled.h"

namespace scanlight::raster {
namespace {

using laws::Counter;
using laws::Counts;
using laws::Random;

using Polygon = std::vector<ClipVertex<1>>;

bool same_bits(const ClipVertex<1>& a, const ClipVertex<1>& b) {
    return a.position == b.position && a.attributes == b.attributes;
}

bool same_bits(const Polygon& a, const Polygon& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& p, const auto& q) { return same_bits(p, q); });
}

bool inside_all(const glm::vec4& p, float slack) {
    return std::all_of(clip_planes.begin(), clip_planes.end(),
                       [&](ClipPlane plane) { return distance(p, plane) >= -slack; });
}

/// A square of half-width `half` about a centre, facing the eye, w = 1.
Polygon square(float x, float y, float z, float half) {
    return {{{x - half, y - half, z, 1.0f}, {0.0f}},
            {{x + half, y - half, z, 1.0f}, {1.0f}},
            {{x + half, y + half, z, 1.0f}, {1.0f}},
            {{x - half, y + half, z, 1.0f}, {0.0f}}};
}

double area(const Polygon& polygon) {  // of w = 1
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i].position;
        const auto& b = polygon[(i + 1) % polygon.size()].position;
        sum += 0.5 * (static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x);
    }
    return sum;
}

TEST(Clip, LeavesWhatIsInsideAsItIs) {
    const Polygon inside = square(0.0f, 0.0f, 0.5f, 1.0f);  // touches four planes
    EXPECT_TRUE(same_bits(clip(inside), inside));
}

TEST(Clip, LeavesNothingOfWhatIsOutside) {
    EXPECT_TRUE(clip(square(-3.0f, 0.0f, 0.5f, 1.0f)).empty());
    EXPECT_TRUE(clip(square(3.0f, 0.0f, 0.5f, 1.0f)).empty());
    EXPECT_TRUE(clip(square(0.0f, -3.0f, 0.5f, 1.0f)).empty());
    EXPECT_TRUE(clip(square(0.0f, 3.0f, 0.5f, 1.0f)).empty());
    EXPECT_TRUE(clip(square(0.0f, 0.0f, -0.5f, 1.0f)).empty());
    EXPECT_TRUE(clip(square(0.0f, 0.0f, 1.5f, 1.0f)).empty());
    EXPECT_TRUE(clip(square(3.0f, 3.0f, 0.5f, 2.5f)).size() == 4);
    EXPECT_TRUE(clip(Polygon{}).empty());
}

TEST(Clip, CutsASquareAtEachSideAndCorner) {
    EXPECT_NEAR(area(clip(square(-1.0f, 0.0f, 0.5f, 0.5f))), 0.5, 1e-6);
    EXPECT_NEAR(area(clip(square(1.0f, 0.0f, 0.5f, 0.5f))), 0.5, 1e-6);
    EXPECT_NEAR(area(clip(square(0.0f, -1.0f, 0.5f, 0.5f))), 0.5, 1e-6);
    EXPECT_NEAR(area(clip(square(0.0f, 1.0f, 0.5f, 0.5f))), 0.5, 1e-6);
    EXPECT_NEAR(area(clip(square(1.0f, 1.0f, 0.5f, 0.5f))), 0.25, 1e-6);
    EXPECT_NEAR(area(clip(square(0.0f, 0.0f, 0.5f, 7.0f))), 4.0, 1e-5);
}

TEST(Clip, CutsAtTheNearAndTheFarPlane) {
    const Polygon ramp{{{-0.5f, 0.0f, -1.0f, 1.0f}, {-1.0f}},
                       {{0.5f, 0.0f, 2.0f, 1.0f}, {2.0f}},
                       {{0.5f, 0.5f, 2.0f, 1.0f}, {2.0f}},
                       {{-0.5f, 0.5f, -1.0f, 1.0f}, {-1.0f}}};
    const Polygon cut = clip(ramp);
    ASSERT_EQ(cut.size(), 4u);
    for (const auto& v : cut) {
        EXPECT_TRUE(v.position.z == 0.0f || std::abs(v.position.z - 1.0f) < 1e-6f);
        EXPECT_NEAR(v.attributes[0], v.position.z, 1e-6f);
    }
}

TEST(Clip, DropsWhatLiesBehindTheEye) {
    const Polygon behind{{{0.0f, 0.0f, -2.0f, -1.0f}, {0.0f}},
                         {{0.5f, 0.0f, -2.0f, -1.0f}, {0.0f}},
                         {{0.0f, 0.5f, -2.0f, -1.0f}, {0.0f}}};
    EXPECT_TRUE(clip(behind).empty());
}

glm::vec4 random_position(Random& random) {
    const float w = random.real(-1.0f, 3.0f);
    return {random.real(-4.0f, 4.0f), random.real(-4.0f, 4.0f), random.real(-2.0f, 4.0f), w};
}

Polygon random_triangle(Random& random) {
    Polygon t(3);
    for (auto& v : t)
        v = {random_position(random), {random.real(-1.0f, 1.0f)}};
    return t;
}

TEST(Clip, KeepsWithinAllPlanesAndWPositive) {
    Random random(1);
    int left = 0;
    for (int i = 0; i < laws::million; ++i) {
        const Polygon clipped = clip(random_triangle(random));
        ASSERT_TRUE(clipped.empty() || clipped.size() >= 3);
        ASSERT_LE(clipped.size(), 3u + 6u);  // one more corner for each plane at most
        for (const auto& v : clipped) {
            ASSERT_TRUE(inside_all(v.position, 2e-6f));
            ASSERT_GE(v.position.w, 0.0f);
        }
        left += clipped.empty() ? 0 : 1;
    }
    EXPECT_GT(left, laws::million / 10);
}

TEST(Clip, GrowsByAtMostOneCornerForEachPlane) {
    Random random(2);
    for (int i = 0; i < laws::million; ++i) {
        const Polygon triangle = random_triangle(random);
        for (const ClipPlane plane : clip_planes)
            ASSERT_LE(clip_against(triangle, plane).size(), 4u);
    }
}

/// The corners that an edge leaves in a clipped triangle: those with nothing of the third corner.
std::vector<glm::vec4> left_of_edge(const ClipVertex<1>& a, const ClipVertex<1>& b,
                                    const glm::vec4& third) {
    std::vector<glm::vec4> result;
    for (const auto& v : clip(Polygon{a, b, {third, {1.0f}}})) {
        if (v.attributes[0] == 0.0f) result.push_back(v.position);
    }
    std::sort(result.begin(), result.end(), [](const glm::vec4& p, const glm::vec4& q) {
        return std::tie(p.x, p.y, p.z, p.w) < std::tie(q.x, q.y, q.z, q.w);
    });
    return result;
}

TEST(Clip, SharedEdgeIsCutInTheSameBitsFromBothSides) {
    Random random(3);
    int cut = 0;
    for (int i = 0; i < laws::million; ++i) {
        const ClipVertex<1> a{random_position(random), {0.0f}};
        const ClipVertex<1> b{random_position(random), {0.0f}};
        const auto one = left_of_edge(a, b, random_position(random));
        const auto other = left_of_edge(b, a, random_position(random));
        ASSERT_EQ(one, other);
        cut += one.empty() ? 0 : 1;
    }
    EXPECT_GT(cut, laws::million / 10);
}

float linear(const glm::vec4& p) {
    return 0.3f * p.x - 0.2f * p.y + 0.1f * p.z + 0.05f * p.w;
}

TEST(Clip, KeepsLinearAttributesLinear) {
    Random random(4);
    for (int i = 0; i < laws::million; ++i) {
        Polygon triangle = random_triangle(random);
        for (auto& v : triangle)
            v.attributes[0] = linear(v.position);
        for (const auto& v : clip(triangle))
            ASSERT_NEAR(v.attributes[0], linear(v.position), 3e-6f);
    }
}

/// What lies beyond the left plane, mirrored to its inside.
Polygon mirrored(Polygon polygon) {
    for (auto& v : polygon)
        v.position.x = -2.0f - v.position.x;
    return polygon;
}

TEST(Clip, AreaInsideAndAreaOutsideAreTheWhole) {
    Random random(5);
    for (int i = 0; i < laws::million; ++i) {
        Polygon triangle = random_triangle(random);
        for (auto& v : triangle)
            v.position.w = 1.0f;
        const double inside = area(clip_against(triangle, ClipPlane::left));
        const double outside = -area(clip_against(mirrored(triangle), ClipPlane::left));
        ASSERT_NEAR(inside + outside, area(triangle), 2e-5);
    }
}

TEST(Clip, SurvivesNumbersThatAreNone) {
    constexpr float bad[] = {std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity(), -1e38f, 1e38f, 0.0f};
    Random random(6);
    for (int i = 0; i < laws::cases(200'000); ++i) {
        Polygon triangle = random_triangle(random);
        for (auto& v : triangle)
            v.position[random.between(0, 3)] = bad[random.between(0, 4)];
        for (const auto& v : project_affine(clip(triangle), {100, 50})) {
            ASSERT_TRUE(v.x >= 0 && v.x <= 100 * subpixels);
            ASSERT_TRUE(v.y >= 0 && v.y <= 50 * subpixels);
            ASSERT_TRUE(v.z >= 0 && v.z <= depth_far);
        }
    }
}

// Meshes that are clipped, projected and filled: no holes, nothing twice.

constexpr int side = 24;  // pixels

/// A random rotation, from a random quaternion.
glm::mat3 random_rotation(Random& random) {
    float q[4];
    float length = 0.0f;
    do {
        length = 0.0f;
        for (float& part : q) {
            part = random.real(-1.0f, 1.0f);
            length += part * part;
        }
    } while (length < 0.01f || length > 1.0f);
    const float s = 2.0f / length;
    const auto [x, y, z, w] = q;
    return {1 - s * (y * y + z * z), s * (x * y + z * w),     s * (x * z - y * w),
            s * (x * y - z * w),     1 - s * (x * x + z * z), s * (y * z + x * w),
            s * (x * z + y * w),     s * (y * z - x * w),     1 - s * (x * x + y * y)};
}

/// A square view of 90 degrees from the origin down the negative z axis.
struct View {
    glm::mat3 eye_from_world;
    float near, far;

    ClipVertex<0> operator()(const glm::vec3& world) const {
        const glm::vec3 p = eye_from_world * world;
        const float scale = far / (far - near);
        return {{p.x, p.y, -scale * p.z - scale * near, -p.z}, {}};
    }
};

void fill(Counter& counter, const View& view, const std::vector<glm::vec3>& corners,
          Counts& counts) {
    std::vector<ClipVertex<0>> polygon;
    for (const auto& corner : corners)
        polygon.push_back(view(corner));
    counter.add(project_affine(clip(polygon), {side, side}), counts);
}

/// A cell abcd as two triangles.
void fill_cell(Counter& counter, const View& view, const std::array<glm::vec3, 4>& q,
               Counts& counts) {
    fill(counter, view, {q[0], q[1], q[2]}, counts);
    fill(counter, view, {q[2], q[3], q[0]}, counts);
}

/// A closed mesh about the origin: a cube of n x n cells a side whose corners lie at random
/// distances from 1 to 3, always the same for the same place on the cube.
class Rock {
public:
    Rock(int n, std::uint32_t seed) : n_(n), seed_(seed) {}

    void fill(Counter& counter, const View& view, Counts& counts) const {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int level : {-n_, n_}) {
                for (int a = -n_; a < n_; a += 2) {
                    for (int b = -n_; b < n_; b += 2) {
                        fill_cell(
                            counter, view,
                            {corner(axis, level, a, b), corner(axis, level, a + 2, b),
                             corner(axis, level, a + 2, b + 2), corner(axis, level, a, b + 2)},
                            counts);
                    }
                }
            }
        }
    }

private:
    glm::vec3 corner(int axis, int level, int a, int b) const {
        glm::ivec3 place;
        place[axis] = level;
        place[(axis + 1) % 3] = a;
        place[(axis + 2) % 3] = b;
        const auto key = static_cast<std::uint32_t>(place.x * 1009 + place.y * 31 + place.z);
        const float radius = 1.0f + Random(seed_ ^ (key * 2654435761u)).real(0.0f, 2.0f);
        return glm::vec3(place) * (radius / static_cast<float>(n_));
    }

    int n_;
    std::uint32_t seed_;
};

TEST(ClippedMeshes, AroundTheEyeFillEachPixelOnce) {
    Random random(7);
    Counter counter;
    for (int i = 0; i < laws::cases(1000); ++i) {
        const View view{random_rotation(random), random.real(0.05f, 0.5f), 100.0f};
        Counts counts = laws::no_counts(side);
        Rock(random.between(1, 4), static_cast<std::uint32_t>(i)).fill(counter, view, counts);
        for (const int n : counts.values())
            ASSERT_EQ(n, 1) << "mesh " << i;
    }
}

/// A floor that passes below the eye and on behind it, cut by all planes.
struct Floor {
    static constexpr int cells = 10;
    static constexpr float reach = 20.0f;
    float depth_below;
    std::vector<glm::vec3> corners;

    Floor(Random& random, float below) : depth_below(below) {
        for (int j = 0; j <= cells; ++j) {
            for (int i = 0; i <= cells; ++i)
                corners.push_back({shaken(random, i), -below, shaken(random, j)});
        }
    }

    static float shaken(Random& random, int i) {
        const bool border = i == 0 || i == cells;
        const float place = static_cast<float>(i) + (border ? 0.0f : random.real(-0.24f, 0.24f));
        return (place / cells * 2.0f - 1.0f) * reach;
    }

    const glm::vec3& at(int i, int j) const {
        return corners[static_cast<std::size_t>(j * (cells + 1) + i)];
    }

    void fill(Counter& counter, const View& view, Counts& counts) const {
        for (int j = 0; j < cells; ++j) {
            for (int i = 0; i < cells; ++i) {
                fill_cell(counter, view, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)},
                          counts);
            }
        }
    }
};

/// Fewest and most times a pixel may show the floor: its ray meets it, or misses it, or passes so
/// close to a border that snapping decides.
struct Range {
    int least, most;
};

Range expected(const Floor& floor, const View& view, int column, int row) {
    const auto in_view = [](int pixel) {
        return (static_cast<float>(pixel) + 0.5f) / (0.5f * side) - 1.0f;
    };
    const glm::vec3 eye_ray{in_view(column), -in_view(row), -1.0f};
    const glm::vec3 ray = eye_ray * view.eye_from_world;  // the inverse rotation
    if (ray.y > -0.001f) return {0, ray.y < 0.001f ? 1 : 0};
    const float w = -floor.depth_below / ray.y;
    const float away = std::max(std::abs(ray.x), std::abs(ray.z)) * w;
    constexpr float slack = 1.03f;
    const bool hits = w > view.near * slack && w * slack < view.far && away * slack < Floor::reach;
    const bool misses =
        w * slack < view.near || w > view.far * slack || away > Floor::reach * slack;
    return {hits ? 1 : 0, misses ? 0 : 1};
}

TEST(ClippedMeshes, ThroughTheNearPlaneHaveNoHolesAndNothingTwice) {
    Random random(8);
    Counter counter;
    int shown = 0;
    for (int i = 0; i < laws::cases(2000); ++i) {
        const Floor floor(random, random.real(0.3f, 1.0f));
        const View view{random_rotation(random), random.real(0.3f, 1.5f), 15.0f};
        Counts counts = laws::no_counts(side);
        floor.fill(counter, view, counts);
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const Range range = expected(floor, view, column, row);
                ASSERT_GE(counts.at(column, row), range.least)
                    << i << ": " << column << ", " << row;
                ASSERT_LE(counts.at(column, row), range.most) << i << ": " << column << ", " << row;
                shown += range.least;
            }
        }
    }
    EXPECT_GT(shown, laws::cases(2000) * side * side / 10);
}

}  // namespace
}  // namespace scanlight::raster
