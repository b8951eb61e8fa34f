#include "render/shadow_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/flat_polygons.h"
#include "render/light_view.h"
#include "render/lit_share.h"
#include "tests/raster/cases.h"
#include "tests/render/shadow_agreement.h"

namespace scanlight::render {
namespace {

/// A plane of two squares a side, turned at random, and a light that shines on it.
struct TurnedPlane {
    mesh::Mesh mesh = shape_mesh("plane:2");
    Object object = object_of(mesh);
    glm::dvec3 normal;

    explicit TurnedPlane(Random& random) {
        const glm::dvec3 y = random.direction();
        const glm::dvec3 x = glm::normalize(glm::cross(y, random.direction()));
        object.world_from_object[0] = glm::dvec4(3.0 * x, 0.0);
        object.world_from_object[1] = glm::dvec4(y, 0.0);
        object.world_from_object[2] = glm::dvec4(3.0 * glm::cross(x, y), 0.0);
        object.world_from_object[3] = glm::dvec4(random.in_cube(2.0), 1.0);
        normal = y;
    }

    glm::dvec3 point(Random& random) const {
        const double x = random.between(-1.0, 1.0);
        const double z = random.between(-1.0, 1.0);
        return glm::dvec3(object.world_from_object * glm::dvec4(x, 0.0, z, 1.0));
    }

    /// Of some points, how many the map finds in shadow.
    int shadowed(Random& random, const ShadowMapRule& rule) const {
        const bool is_point = random.below(2) == 0;
        const glm::dvec3 away = normal + 0.8 * random.direction();
        const glm::dvec3 middle(object.world_from_object[3]);
        const glm::dvec4 light =
            is_point ? glm::dvec4(middle + 2.0 * away, 1.0) : glm::dvec4(glm::normalize(away), 0.0);
        const ShadowMap map = drawn_shadow_map({object}, light, rule);
        int count = 0;
        for (int i = 0; i < 200; ++i)
            count += map.share(glm::vec3(point(random))) < 1.0f ? 1 : 0;
        return count;
    }
};

TEST(ShadowMap, HalfACellOfBiasKeepsAPlaneFromShadowingItself) {
    Random random(1);
    int without = 0;
    for (int i = 0; i < 100; ++i) {
        const TurnedPlane plane(random);
        EXPECT_EQ(plane.shadowed(random, {.size = 64, .bias = 0.51}), 0) << i;
        EXPECT_EQ(plane.shadowed(random, {.size = 64, .bias = 0.51, .filter = 5}), 0) << i;
        without += plane.shadowed(random, {.size = 64, .bias = 0.0});
    }
    EXPECT_GT(without, 1000);
}

/// A square over a wide floor, the light above.
class MapOfASquare : public testing::Test {
protected:
    MapOfASquare() {
        objects_ = {object_of(mesh_), object_of(mesh_)};
        objects_[0].world_from_object[0][0] = objects_[0].world_from_object[2][2] = 4.0;
        objects_[1].world_from_object[3][1] = 2.0;
    }

    /// Along x, at z = 0 on the floor.
    static float share(const ShadowMap& map, double x) {
        return map.share(glm::vec3(static_cast<float>(x), 0.0f, 0.0f));
    }

    mesh::Mesh mesh_ = shape_mesh("plane:1");
    std::vector<Object> objects_;
};

// From (0, 4, 0) the square, 2 wide and half way, shadows 4 of the floor.
TEST_F(MapOfASquare, ShadowsWhatIsBehindIt) {
    const ShadowMap map = drawn_shadow_map(objects_, {0.0, 4.0, 0.0, 1.0}, {.size = 1024});
    EXPECT_EQ(share(map, 1.98), 0.0f);
    EXPECT_EQ(share(map, 0.0), 0.0f);
    EXPECT_EQ(share(map, 2.02), 1.0f);
    EXPECT_EQ(map.share({0.0f, 2.0f, 0.0f}), 1.0f);  // the square itself
}

TEST_F(MapOfASquare, OfParallelLightShadowsAsMuch) {
    const ShadowMap map = drawn_shadow_map(objects_, {0.0, 1.0, 0.0, 0.0}, {.size = 1024});
    EXPECT_EQ(share(map, 0.98), 0.0f);
    EXPECT_EQ(share(map, 1.02), 1.0f);
    EXPECT_EQ(map.share({0.0f, 2.0f, 0.0f}), 1.0f);
}

TEST_F(MapOfASquare, FilteredHasSharesThatRiseAcrossTheEdge) {
    constexpr int filter = 7;
    const ShadowMap map =
        drawn_shadow_map(objects_, {0.0, 1.0, 0.0, 0.0}, {.size = 256, .filter = filter});
    float before = 0.0f;
    std::vector<float> between;
    for (double x = 0.8; x < 1.2; x += 0.002) {
        const float now = share(map, x);
        EXPECT_GE(now, before);
        const float parts = now * filter * filter;
        EXPECT_NEAR(parts, std::round(parts), 1e-4f);
        if (now != before && now < 1.0f) between.push_back(now);
        before = now;
    }
    EXPECT_EQ(before, 1.0f);
    EXPECT_EQ(between.size(), filter - 1u);
}

TEST_F(MapOfASquare, MovesAShadowByNoMoreThanItsBias) {
    const ShadowMapRule rule{.size = 256, .bias = 8.0};
    const ShadowMap map = drawn_shadow_map(objects_, {0.0, 1.0, 0.0, 0.0}, rule);
    EXPECT_EQ(share(map, 0.9), 0.0f);  // the square is far more than 8 cells above
    // A second square, 12 cells of 8 / 256 and a little over the floor, shadows it; one 4 cells
    // over it does not.
    for (const auto& [height, expected] : {std::pair{0.6, 0.0f}, std::pair{0.12, 1.0f}}) {
        objects_[1].world_from_object[3][1] = height;
        EXPECT_EQ(share(drawn_shadow_map(objects_, {0.0, 1.0, 0.0, 0.0}, rule), 0.0), expected);
    }
}

// ---- agreement with shadow volumes

/// How steeply lights fall on the faces that pixels show.
class Steepness {
public:
    Steepness(const Scene& scene, const Frame& frame, const raster::Plane<std::uint32_t>& items)
        : faces_(flat_faces(scene.objects, 1e-5)), frame_(frame), items_(items) {}

    /// The cosine; less than 0 where the eye and the light are on two sides.
    double at(int x, int y, raster::Depth depth, std::size_t light) const {
        const Corners& corners = faces_[items_.at(x, y) - 1].corners;
        const glm::vec3 point = frame_.point_at(x, y, depth);
        const auto incident = shading::incident_at(frame_.lighting.lights[light], point);
        const glm::dvec3 normal = plane_of(corners).normal;
        const double to_eye = glm::dot(normal, glm::dvec3(frame_.view_from(point)));
        return glm::dot(normal, glm::dvec3(incident.direction)) * (to_eye < 0.0 ? -1.0 : 1.0);
    }

private:
    std::vector<FlatFace> faces_;
    const Frame& frame_;
    const raster::Plane<std::uint32_t>& items_;
};

constexpr int map_size = 2048;

/// How wide the cells of a light's maps are, across the light.
class CellWidth {
public:
    CellWidth(const Scene& scene, std::size_t light)
        : from_(homogeneous(scene.lighting.lights[light])) {
        for (const auto& camera : light_cameras(from_, scene.objects))
            views_.emplace_back(camera);
    }

    double at(const glm::dvec3& point) const {
        const LightView& view = views_[from_.w == 0.0 ? 0 : cube_face(point - glm::dvec3(from_))];
        return 2.0 * view.half_width(view.seen(point).z) / map_size;
    }

private:
    glm::dvec4 from_;
    std::vector<LightView> views_;
};

/// How far apart neighbouring pixels are at a depth.
double pixel_width(const Frame& frame, int x, int y, raster::Depth depth) {
    return glm::distance(glm::dvec3(frame.point_at(x, y, depth)),
                         glm::dvec3(frame.point_at(x + 1, y, depth)));
}

// Within a cell of its edge a shadow may be anything. So cells must be no larger than pixels, on
// the face that they lie on: near the eye they are larger, and where light grazes a face.
TEST(ShadowMap, AgreesWithShadowVolumes) {
    constexpr raster::Viewport viewport{63, 47};
    constexpr std::uint32_t scenes = raster::laws::thorough ? 200 : 30;
    int compared = 0;
    int shadowed = 0;
    int different = 0;
    for (std::uint32_t seed = 0; seed < scenes; ++seed) {
        const RandomScene random = random_scene(seed, 3);
        const Scene& scene = random.scene;
        const auto depth = draw_depth(scene, {}, viewport).framebuffer.depth;
        const auto items = draw_items(scene, {}, viewport);
        const Frame frame = frame_of(scene, Distances::finite, viewport);
        const Steepness steepness(scene, frame, items);
        for (std::size_t light = 0; light < scene.lighting.lights.size(); ++light) {
            Settings settings;
            settings.shadows = Shadows::zfail;
            const auto expected = lit_share(scene, settings, light, depth);
            settings.shadows = Shadows::map;
            settings.shadow_map.size = map_size;
            const auto found = lit_share(scene, settings, light, depth);
            const CellWidth cell_width(scene, light);
            for_each_pixel(viewport, [&](int x, int y) {
                const raster::Depth z = depth.at(x, y);
                const bool at_edge = !is_even(expected, x, y) || !is_even(items, x, y);
                if (z == raster::depth_clear || at_edge) return;
                const double steep = steepness.at(x, y, z, light);
                const double cell = cell_width.at(frame.point_at(x, y, z));
                if (steep < 0.14 || cell / steep > pixel_width(frame, x, y, z)) return;
                ++compared;
                shadowed += expected.at(x, y) == 0.0f ? 1 : 0;
                different += found.at(x, y) != expected.at(x, y) ? 1 : 0;
            });
        }
    }
    EXPECT_EQ(different, 0);
    EXPECT_GT(compared, 500 * scenes);
    EXPECT_GT(shadowed, 66 * scenes);
}

}  // namespace
}  // namespace scanlight::render
