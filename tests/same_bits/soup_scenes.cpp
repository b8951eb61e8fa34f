#include <cmath>
#include <cstdint>

#include "mesh/trigonometry.h"
#include "tests/render/scenes.h"
#include "tests/same_bits/lights.h"
#include "tests/same_bits/materials.h"
#include "tests/same_bits/pixel_view.h"
#include "tests/same_bits/plain_mesh.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

namespace {

using namespace render;

/// Where equal depths are to be found, and where they are not.
enum class Depths { any, few_levels };

struct SoupRule {
    std::uint32_t seed;
    int polygons;
    int least_log2;  // half of a polygon's size in pixels, from 2^least to 2^(most + 1)
    int most_log2;
    Depths depths = Depths::any;
    std::size_t materials = 1;
    Colors colors = Colors::none;
};

/// Makes random polygons in the world of `pixel_camera`.
class Soup {
public:
    Soup(const SoupRule& rule, raster::Viewport size)
        : rule_(rule), size_(size), random_(rule.seed) {}

    mesh::Mesh mesh() {
        for (int i = 0; i < rule_.polygons; ++i)
            polygons_.push_back(any_polygon());
        return plain_mesh(polygons_, rule_.materials, rule_.colors);
    }

private:
    PlainPolygon any_polygon() {
        place_next();
        switch (random_.below(10)) {
            case 0:
                return needle();
            case 1:
                return without_area();
            case 2:
                return convex();
            case 3:
                return polygons_.empty() ? triangle() : seen_before();
            default:
                return triangle();
        }
    }

    /// The next polygon's centre, beside the picture too, size and depth.
    void place_next() {
        center_.x = random_.between(-0.2, 1.2) * size_.width;
        center_.y = random_.between(-0.2, 1.2) * size_.height;
        const int exponents = rule_.most_log2 - rule_.least_log2 + 1;
        const int exponent = rule_.least_log2 + random_.below(exponents);
        radius_ = std::ldexp(random_.between(1.0, 2.0), exponent);
        center_.z = rule_.depths == Depths::few_levels ? random_.below(3)
                                                       : random_.between(lowest_z, highest_z);
    }

    PlainPolygon triangle() { return of({corner(), corner(), corner()}); }

    /// Two corners far apart, and one almost between them.
    PlainPolygon needle() {
        const glm::dvec3 a = place();
        const glm::dvec3 b = place();
        const double part = random_.between(0.0, 1.0);
        const double off = random_.between(-0.05, 0.05);
        return of({corner_at(a), corner_at(b), corner_at(a + part * (b - a) + off)});
    }

    /// A corner twice, or three on a line, or three times the same.
    PlainPolygon without_area() {
        const glm::dvec3 a = place();
        const glm::dvec3 b = place();
        const glm::dvec3 third[] = {a, 0.5 * (a + b), b};
        const int which = random_.below(4);
        return of({corner_at(a), corner_at(which == 3 ? a : b), corner_at(third[which % 3])});
    }

    /// 4 to 7 corners on an ellipse.
    PlainPolygon convex() {
        const int n = 4 + random_.below(4);
        const double turn = random_.between(0.0, 6.0);
        const double flat = random_.between(-1.0, 1.0);
        const double depth = depth_range() * random_.between(-1.0, 1.0);
        std::vector<PlainCorner> corners;
        for (int i = 0; i < n; ++i) {
            const double angle = turn + 2.0 * mesh::pi * i / n;
            const glm::dvec3 out(mesh::cosine(angle), flat * mesh::sine(angle), 0.0);
            corners.push_back(
                corner_at(center_ + radius_ * out + glm::dvec3(0.0, 0.0, depth * out.x)));
        }
        return of(std::move(corners));
    }

    /// The same once more, of another material and other normals: all its depths are ties.
    PlainPolygon seen_before() {
        const auto count = static_cast<int>(polygons_.size());
        auto corners = polygons_[static_cast<std::size_t>(random_.below(count))].corners;
        for (PlainCorner& corner : corners)
            corner.normal = normal();
        return of(std::move(corners));
    }

    double depth_range() const { return rule_.depths == Depths::any ? 4.0 : 0.0; }

    glm::dvec3 place() {
        const glm::dvec3 off = random_.in_cube(1.0);
        return center_ + off * glm::dvec3(radius_, radius_, depth_range());
    }
    PlainCorner corner() { return corner_at(place()); }
    PlainCorner corner_at(const glm::dvec3& p) {
        const glm::vec3 n = normal();
        return {at_pixel(p.x, p.y, p.z), n, glm::vec3(random_.in_cube(0.5) + 0.5)};
    }
    PlainPolygon of(std::vector<PlainCorner> corners) {
        const int material = random_.below(static_cast<int>(rule_.materials));
        return {std::move(corners), normal(), static_cast<std::uint32_t>(material)};
    }
    glm::vec3 normal() { return glm::vec3(random_.direction()); }

    SoupRule rule_;
    raster::Viewport size_;
    Random random_;
    glm::dvec3 center_{0.0};  // pixels, y down
    double radius_ = 0.0;     // pixels
    std::vector<PlainPolygon> polygons_;
};

TestScene soup(const SoupRule& rule, raster::Viewport size, const Settings& settings) {
    TestScene test{size, settings, {}, {}};
    const mesh::Mesh& mesh = test.keep(Soup(rule, size).mesh());
    test.scene.objects = {{&mesh, several_materials(rule.materials)}};
    test.scene.camera = pixel_camera(size);
    test.scene.lighting = lighting(2);
    test.scene.background = {0.2f, 0.1f, 0.05f, 1.0f};
    return test;
}

/// The same polygons around a perspective eye: many reach behind it.
TestScene soup_around(const SoupRule& rule, raster::Viewport size, const Settings& settings) {
    TestScene test = soup(rule, size, settings);
    glm::dmat4 placing(1.0);
    placing[0][0] = 4.0 / size.width;
    placing[1][1] = 4.0 / size.height;
    placing[2][2] = 0.5;
    placing[3] = glm::dvec4(-2.0, 2.0, 0.0, 1.0);
    test.scene.objects[0].world_from_object = placing;
    test.scene.camera = {.eye = {0.1, 0.2, 2.0}, .target = {0.0, 0.0, -1.0}, .near = 0.01};
    test.scene.lighting = lighting(3);
    return test;
}

}  // namespace

NamedScenes soup_scenes() {
    constexpr auto affine = Perspective::affine;
    const Settings flat{.shading = Shading::flat};
    const Settings gouraud{.shading = Shading::gouraud};
    const Settings phong{.illumination = shading::Illumination::blinn};
    const Settings flat_culled{.shading = Shading::flat, .cull = Cull::back};
    const Settings gouraud_affine{
        .shading = Shading::gouraud, .perspective = affine, .cull = Cull::front};
    const Settings phong_one_side{.perspective = affine, .sides = Sides::one};
    const Colors colored = Colors::vertices;
    return {
        {"soup/specks/flat",
         [=] {
             return soup({1, 4000, -5, -1}, {97, 65}, flat);
         }},
        {"soup/specks/phong",
         [=] {
             return soup({2, 4000, -5, -1}, {64, 100}, phong);
         }},
        {"soup/small/gouraud",
         [=] {
             return soup({3, 1500, -2, 3}, {101, 77}, gouraud);
         }},
        {"soup/small/phong-colored",
         [=] {
             return soup({4, 1500, -2, 3, Depths::any, 3, colored}, {101, 77}, phong);
         }},
        {"soup/all-sizes/flat",
         [=] {
             return soup({5, 400, -4, 7, Depths::any, 4}, {150, 70}, flat);
         }},
        {"soup/all-sizes/gouraud-affine-cull-front",
         [=] {
             return soup({6, 400, -4, 7, Depths::any, 2}, {150, 70}, gouraud_affine);
         }},
        {"soup/all-sizes/phong-affine-one-side",
         [=] {
             return soup({7, 300, -4, 7}, {150, 70}, phong_one_side);
         }},
        {"soup/beyond-the-screen/gouraud",
         [=] {
             return soup({8, 100, 6, 20}, {97, 65}, gouraud);
         }},
        {"soup/ties/flat-cull-back",
         [=] {
             return soup({9, 400, -2, 6, Depths::few_levels, 5}, {150, 70}, flat_culled);
         }},
        {"soup/ties/gouraud-colored",
         [=] {
             return soup({10, 400, -2, 6, Depths::few_levels, 2, colored}, {150, 70}, gouraud);
         }},
        {"soup/ties/phong",
         [=] {
             return soup({11, 300, -2, 6, Depths::few_levels, 5}, {150, 70}, phong);
         }},
        {"soup/around/flat-cull-back",
         [=] {
             return soup_around({12, 400, -3, 7}, {120, 90}, flat_culled);
         }},
        {"soup/around/gouraud",
         [=] {
             return soup_around({13, 400, -3, 7, Depths::any, 3}, {120, 90}, gouraud);
         }},
        {"soup/around/gouraud-colored",
         [=] {
             return soup_around({14, 400, -3, 7, Depths::any, 3, colored}, {120, 90}, gouraud);
         }},
        {"soup/around/gouraud-affine-cull-front",
         [=] {
             return soup_around({15, 400, -3, 7}, {120, 90}, gouraud_affine);
         }},
        {"soup/around/phong",
         [=] {
             return soup_around({16, 300, -3, 7, Depths::any, 3}, {120, 90}, phong);
         }},
        {"soup/around/phong-colored",
         [=] {
             return soup_around({17, 300, -3, 7, Depths::any, 3, colored}, {120, 90}, phong);
         }},
        {"soup/around/phong-affine-one-side",
         [=] {
             return soup_around({18, 300, -3, 7}, {120, 90}, phong_one_side);
         }},
    };
}

}  // namespace scanlight::same_bits
