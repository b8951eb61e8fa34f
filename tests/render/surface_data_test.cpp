// The pictures of data: which polygon, which normal, how far; held against rays.
#include "render/surface_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

constexpr raster::Viewport size{64, 48};

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

struct Hit {
    std::uint32_t id;
    double t;
};

/// Möller & Trumbore 1997.
std::optional<double> distance_along(const Ray& ray, const std::array<glm::dvec3, 3>& t) {
    const glm::dvec3 e1 = t[1] - t[0];
    const glm::dvec3 e2 = t[2] - t[0];
    const glm::dvec3 p = glm::cross(ray.direction, e2);
    const double det = glm::dot(e1, p);
    if (det == 0.0) return std::nullopt;
    const glm::dvec3 s = ray.origin - t[0];
    const double u = glm::dot(s, p) / det;
    const glm::dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(ray.direction, q) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) return std::nullopt;
    return glm::dot(e2, q) / det;
}

std::array<glm::dvec3, 3> triangle(const mesh::Mesh& mesh, std::size_t face) {
    const auto corners = mesh.face(face);
    return {glm::dvec3(mesh.vertices.position(corners[0])),
            glm::dvec3(mesh.vertices.position(corners[1])),
            glm::dvec3(mesh.vertices.position(corners[2]))};
}

std::optional<Hit> nearest_hit(const Ray& ray, const mesh::Mesh& mesh) {
    std::optional<Hit> nearest;
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const auto t = distance_along(ray, triangle(mesh, face));
        if (t && *t > 0.0 && (!nearest || *t < nearest->t))
            nearest = Hit{mesh.face_id[face] + 1, *t};
    }
    return nearest;
}

/// Through a pixel's centre; t is the distance along the view.
Ray ray_through(const Camera& camera, int x, int y) {
    const double aspect = static_cast<double>(size.width) / size.height;
    const glm::dvec2 place(((x + 0.5) / size.width * 2.0 - 1.0) * aspect / camera.magnification,
                           (1.0 - (y + 0.5) / size.height * 2.0) / camera.magnification);
    const glm::dmat3 world_from_eye = glm::transpose(glm::dmat3(eye_from_world(camera)));
    if (camera.projection == Projection::perspective)
        return {camera.eye, world_from_eye * glm::dvec3(place, -1.0)};
    return {camera.eye + world_from_eye * glm::dvec3(place, 0.0),
            world_from_eye * glm::dvec3(0.0, 0.0, -1.0)};
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 ab = b - a;
    const double t = std::clamp(glm::dot(p - a, ab) / std::max(glm::dot(ab, ab), 1e-30), 0.0, 1.0);
    return glm::length(p - (a + t * ab));
}

/// From a pixel's centre to the nearest edge of any polygon on the picture, in pixels.
double distance_to_edges(const Scene& scene, const mesh::Mesh& mesh, int x, int y) {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
        const auto corners = triangle(mesh, face);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 a(screen_from_world(scene.camera, size, corners[i]));
            const glm::dvec2 b(screen_from_world(scene.camera, size, corners[(i + 1) % 3]));
            nearest = std::min(nearest, distance_to_segment({x + 0.5, y + 0.5}, a, b));
        }
    }
    return nearest;
}

class AgainstRays : public testing::TestWithParam<Projection> {
protected:
    const mesh::Mesh mesh = mesh::triangulated(shape_mesh("torus:8,5"));
    const Scene scene = scene_of(mesh, {{30.0, 40.0}, size, GetParam()});
};

TEST_P(AgainstRays, EachPixelShowsThePolygonThatItsRayMeetsFirst) {
    const auto ids = draw_ids(scene, {}, size);
    constexpr double snapping = 1.5 / 256.0;  // pixels
    std::size_t shown = 0;
    for_each_pixel(size, [&](int x, int y) {
        const auto hit = nearest_hit(ray_through(scene.camera, x, y), mesh);
        const std::uint32_t expected = hit ? hit->id : 0;
        shown += expected != 0 ? 1 : 0;
        if (ids.at(x, y) != expected) {
            EXPECT_LT(distance_to_edges(scene, mesh, x, y), snapping) << x << ' ' << y;
        }
    });
    EXPECT_GT(shown, 500u);
}

TEST_P(AgainstRays, DistancesAreThoseOfTheRays) {
    const auto framebuffer = draw(scene, {}, size).framebuffer;
    const auto ids = draw_ids(scene, {}, size);
    const auto distances = eye_distances(framebuffer.depth, scene.camera);
    for_each_pixel(size, [&](int x, int y) {
        const auto hit = nearest_hit(ray_through(scene.camera, x, y), mesh);
        if (ids.at(x, y) == 0) {
            EXPECT_EQ(distances.at(x, y), 0.0f);
        } else if (hit && hit->id == ids.at(x, y)) {
            // Corners are snapped to 1/512 pixel, so on steep polygons depth moves too.
            EXPECT_NEAR(distances.at(x, y), hit->t, 2e-2) << x << ' ' << y;
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Cameras, AgainstRays, testing::ValuesIn(all_projections),
                         [](const auto& param) {
                             return param.param == Projection::perspective ? "perspective"
                                                                           : "orthographic";
                         });

TEST(EyeDistances, OfAFlatWallAreItsDistance) {
    const auto mesh = shape_mesh("ngon:4");
    for (const Projection projection : all_projections) {
        Scene scene = scene_of(mesh, {{0.0, 0.0}, size, projection});
        scene.camera.near = 0.5;
        scene.camera.far = 50.0;
        const auto framebuffer = draw(scene, {}, size).framebuffer;
        const auto distances = eye_distances(framebuffer.depth, scene.camera);
        EXPECT_NEAR(distances.at(size.width / 2, size.height / 2), scene.camera.eye.z, 1e-4);
        EXPECT_EQ(distances.at(0, 0), 0.0f);
    }
}

TEST(Ids, AreOfFacesThatExist) {
    const auto mesh = shape_mesh("teapot:3");
    const auto ids = draw_ids(scene_of(mesh, {{}, size}), {}, size);
    for (const std::uint32_t id : ids.values())
        ASSERT_LE(id, mesh.face_count());
}

TEST(Ids, NameTheFacesPlaceInTheFile) {
    mesh::PolygonSoup soup = mesh::shape("cube");
    // A face without area before the others: it is dropped, and they keep their numbers.
    soup.corners.insert(soup.corners.begin(), {{0}, {0}, {0}});
    for (auto& begin : soup.face_begin)
        begin += 3;
    soup.face_begin.insert(soup.face_begin.begin(), 0);
    const auto mesh = mesh::build(soup).mesh;
    ASSERT_EQ(mesh.face_count(), 6u);
    const auto cube = shape_mesh("cube");
    const auto expected = draw_ids(scene_of(cube, {{}, size}), {}, size);
    const auto ids = draw_ids(scene_of(mesh, {{}, size}), {}, size);
    for_each_pixel(size, [&](int x, int y) {
        const std::uint32_t id = expected.at(x, y);
        ASSERT_EQ(ids.at(x, y), id == 0 ? 0 : id + 1);
    });
}

TEST(Ids, CountOnOverTheObjects) {
    const auto left = shape_mesh("cube");
    const auto right = shape_mesh("octahedron");
    Object moved = object_of(right);
    moved.world_from_object[3] = glm::dvec4(4.0, 0.0, 0.0, 1.0);
    const Scene scene = scene_of(std::vector{object_of(left), moved}, {{0.0, 20.0}, size});
    const auto ids = draw_ids(scene, {}, size);
    for_each_pixel(size, [&](int x, int y) {
        if (ids.at(x, y) == 0) return;
        const bool is_left = ids.at(x, y) <= 6;
        ASSERT_EQ(is_left, x < size.width / 2) << x << ' ' << y << ": " << ids.at(x, y);
        ASSERT_LE(ids.at(x, y), 14u);
    });
}

TEST(Normals, AreUnitWhereSomethingIs) {
    const auto mesh = shape_mesh("teapot:3");
    const Scene scene = scene_of(mesh, {{}, size});
    for (const Perspective perspective : {Perspective::correct, Perspective::affine}) {
        Settings settings;
        settings.perspective = perspective;
        const auto normals = draw_normals(scene, settings, size);
        const auto ids = draw_ids(scene, settings, size);
        for_each_pixel(size, [&](int x, int y) {
            const double length = glm::length(glm::dvec3(normals.at(x, y)));
            ASSERT_NEAR(length, ids.at(x, y) == 0 ? 0.0 : 1.0, 1e-6);
        });
    }
}

TEST(Normals, OfASphereAreItsPoints) {
    const auto mesh = shape_mesh("icosphere:4", {.crease_deg = 180.0f});
    const Scene scene = scene_of(mesh, {{}, size});
    const auto normals = draw_normals(scene, {}, size);
    const auto depth = draw(scene, {}, size).framebuffer.depth;
    const Frame frame = frame_of(scene, Distances::finite, size);
    for_each_pixel(size, [&](int x, int y) {
        if (depth.at(x, y) == raster::depth_clear) return;
        const glm::vec3 point = frame.point_at(x, y, depth.at(x, y));
        ASSERT_LT(glm::length(normals.at(x, y) - point), 0.02f);
    });
}

TEST(Normals, FaceTheEyeOnASurfaceWithTwoSides) {
    const auto mesh = shape_mesh("plane:2");
    const Scene scene = scene_of(mesh, {{0.0, -50.0}, size});
    Settings one;
    one.sides = Sides::one;
    const auto turned = draw_normals(scene, {}, size);
    const auto kept = draw_normals(scene, one, size);
    EXPECT_NEAR(turned.at(size.width / 2, size.height / 2).y, -1.0f, 1e-6);
    EXPECT_NEAR(kept.at(size.width / 2, size.height / 2).y, 1.0f, 1e-6);
}

/// Opposed vertex normals cancel half way: there the polygon's own normal is taken.
TEST(Normals, ThatCancelGiveWayToThePolygons) {
    mesh::PolygonSoup soup;
    soup.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    soup.normals = {{1, 0, 0}, {-1, 0, 0}};
    soup.corners = {{0, 0}, {1, 1}, {2, 1}, {3, 0}};
    soup.face_begin = {0, 4};
    const auto mesh = mesh::build(soup, {mesh::NormalWeight::file}).mesh;
    constexpr raster::Viewport odd{65, 65};  // the middle column's centre is the square's
    Scene scene = scene_of(mesh, {{0.0, 0.0}, odd, Projection::orthographic});
    scene.camera.magnification = 1.0;
    const auto normals = draw_normals(scene, {}, odd);
    for (int y = 0; y < odd.height; ++y) {
        EXPECT_EQ(normals.at(32, y), glm::vec3(0, 0, 1));
        EXPECT_EQ(normals.at(31, y), glm::vec3(1, 0, 0));
        EXPECT_EQ(normals.at(33, y), glm::vec3(-1, 0, 0));
    }
}

/// At each pixel that of the normal and the view that other pictures tell.
TEST(FresnelPicture, IsThatOfTheNormalsAndTheEye) {
    const auto mesh = shape_mesh("sphere:24,12");
    Scene scene = scene_of(mesh, {{30.0, 20.0}, size});
    const auto gold = shading::metal({0.21, 0.62, 1.38}, {3.272, 2.081, 1.914});
    scene.objects.front().materials.front().facets.reflectance = gold;
    scene.background = {0.5f, 0.25f, 0.125f, 1.0f};
    const Drawing drawing = draw_fresnel(scene, {}, size);
    const auto normals = draw_normals(scene, {}, size);
    const Frame frame = frame_of(scene, Distances::finite, size);
    for_each_pixel(size, [&](int x, int y) {
        const glm::vec3& N = normals.at(x, y);
        const raster::Rgba& color = drawing.framebuffer.color.at(x, y);
        if (N == glm::vec3(0.0f)) {
            ASSERT_EQ(color, scene.background);
            return;
        }
        const glm::vec3 point = frame.point_at(x, y, drawing.framebuffer.depth.at(x, y));
        const float cosine = std::max(0.0f, glm::dot(N, frame.view_from(point)));
        const glm::dvec3 expected = shading::reflectance_at(static_cast<double>(cosine), gold);
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(color[k], expected[k], 2e-5) << x << ' ' << y;
    });
}

TEST(FresnelPicture, OfAGlassSphereIsWeakInTheMiddleAndBrightAtTheRim) {
    const auto mesh = shape_mesh("sphere:96,48");
    const Scene scene = scene_of(mesh, {{0.0, 0.0}, size});
    const auto color = draw_fresnel(scene, {}, size).framebuffer.color;
    EXPECT_NEAR(color.at(32, 24).r, 0.04, 0.001);
    float brightest = 0.0f;
    for (int x = 0; x < size.width; ++x)
        brightest = std::max(brightest, color.at(x, 24).r);
    EXPECT_GT(brightest, 0.25f);
}

}  // namespace
}  // namespace scanlight::render
