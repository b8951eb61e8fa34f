#pragma once

#include <utility>

#include "raster/lanes/attributes.h"
#include "raster/lanes/numbers.h"
#include "render/object_pass.h"
#include "render/painted.h"
#include "render/shadow_band.h"
#include "render/undivided.h"
#include "render/viewing.h"

namespace scanlight::shading {
template <>
struct Format<raster::HWY_NAMESPACE::Floats> : Format<float> {};
}  // namespace scanlight::shading

namespace scanlight::shading {
template <>
struct Wholes<raster::HWY_NAMESPACE::Floats> {
    using Floats = raster::HWY_NAMESPACE::Floats;
    using Type = raster::HWY_NAMESPACE::Ints;

    static Type truncated(Floats x) { return raster::HWY_NAMESPACE::truncated(x); }
    static Floats real(Type whole) { return floats_of(whole); }
    static Type fetched(const std::int32_t* from, Type index) { return gather(from, index); }
    static raster::HWY_NAMESPACE::IntPairs fetched_two(const std::int32_t* from, Type index) {
        return gather_pairs(from, index);
    }
    static Type shifted_left(Type bits, int by) { return bits_moved_up(bits, by); }
    static Type shifted_right(Type bits, int by) { return bits_moved_down(bits, by); }
    static Type divided_by_power(Type number, int by) {
        return divided_by_power_of_two(number, by);
    }
    static Type sum(Type a, Type b) { return a + b; }
    static Type product(Type a, Type b) { return a * b; }
    static Floats real_of_float_bits(Type bits) { return floats_from_bits(bits); }
};
}  // namespace scanlight::shading

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;
using VectorLanes = shading::Vec3<Floats>;
using ColorLanes = shading::Rgb<Floats>;

/// Vectors that lie one after another in memory.
inline VectorLanes gather(const std::vector<glm::vec3>& vectors, Ints index) {
    const float* base = &vectors.data()->x;
    const Ints first = index * Ints(3);
    return {gather(base, first), gather(base, first + Ints(1)), gather(base, first + Ints(2))};
}

/// Calls `light(number)` for the number of each material among the wanted lanes, and joins what
/// comes of it. Most vectors have one.
template <class Light>
ColorLanes by_material(Ints material, Mask wanted, Light&& light) {
    ColorLanes result(Floats(0));
    for (std::uint32_t left = bits_of(wanted); left != 0;) {
        std::int32_t numbers[lane_count];
        store(material, numbers);
        const std::int32_t number = numbers[std::countr_zero(left)];
        const Mask same = material == Ints(number);
        result = shading::select(same, light(static_cast<std::size_t>(number)), result);
        left &= ~bits_of(same);
    }
    return result;
}

/// `by_material` for an object, most of which have one material.
template <class Light>
ColorLanes light_by_material(const ObjectPass& pass, Ints face, Mask wanted, Light&& light) {
    const auto& materials = pass.object->materials;
    if (materials.size() == 1) return light(materials.front());
    const auto* numbers = reinterpret_cast<const std::int32_t*>(pass.mesh().face_material.data());
    return by_material(gather(numbers, face), wanted,
                       [&](std::size_t number) { return light(materials[number]); });
}

// ---- techniques: what a vector of pixels looks like

/// A vector of pixels in a row.
struct PixelLanes {
    int x, y;
    Ints depth;
    Mask shown;     // somewhere
    Ints item;      // where nothing is shown, that of a pixel where something is
    Ints shadowed;  // the lights that do not reach the pixel: their bits
    Ints attributes[raster::most_attributes];

    Ints face() const { return item & Ints(static_cast<std::int32_t>(raster::face_mask)); }
    bool is_one_face() const { return all(item == Ints(first_lane(item))); }
    Mask back() const { return item < Ints(0); }
    VectorLanes vector(int first) const {
        return {float_lanes(attributes[first]), float_lanes(attributes[first + 1]),
                float_lanes(attributes[first + 2])};
    }
};

inline Floats material_opacity(const ObjectPass& pass, const PixelLanes& pixels) {
    const auto of_material = [](const auto& m) { return ColorLanes(Floats(m.opacity)); };
    return light_by_material(pass, pixels.face(), pixels.shown, of_material).x;
}

/// What is left of a light's term where some lights are in shadow.
struct Unshadowed {
    Ints shadowed;

    ColorLanes operator()(std::size_t light, const ColorLanes& term) const {
        const Ints bit(static_cast<std::int32_t>(1u << light % ShadowBand::most_lights));
        return shading::select((shadowed & bit) == Ints(0), term, ColorLanes(Floats(0)));
    }
};

/// One intensity a face: see `FlatTechnique`.
class FlatLanes {
public:
    static constexpr int attributes = 0;

    explicit FlatLanes(const ObjectPass& pass) : pass_(pass) {}

    ColorLanes shade(const PixelLanes& pixels) const {
        return color_of(pixels.item, pixels.shadowed);
    }
    Floats opacity(const PixelLanes& pixels) const { return material_opacity(pass_, pixels); }

    /// A lane is a polygon, or a pixel of one.
    ColorLanes color_of(Ints item, Ints shadowed = Ints(0)) const {
        return with_model(pass_.settings, [&](auto model) { return lit(model, item, shadowed); });
    }

private:
    template <class Model>
    SCANLIGHT_FLATTEN ColorLanes lit(const Model& model, Ints item, Ints shadowed) const {
        const Ints face = item & Ints(static_cast<std::int32_t>(raster::face_mask));
        const VectorLanes point = mean_corner(face);
        const VectorLanes normal = transformed_normal(pass_.placing.normals_from_object,
                                                      gather(pass_.mesh().face_normals, face));
        const VectorLanes seen = shading::select(item < Ints(0), -normal, normal);
        const shading::Surface<Floats> surface{point, seen,
                                               view_from(pass_.frame->viewpoint, point)};
        return light_by_material(pass_, face, first_lanes(lane_count), [&](const auto& material) {
            return with_paint(pass_.mesh(), [&](auto paint) {
                return illuminate(model, surface,
                                  painted_by<paint>(material, [&] { return mean_color(face); }),
                                  pass_.frame->lighting, Unshadowed{shadowed});
            });
        });
    }

    /// Calls `add(vertex, has)` with the corners of each lane's face in their order.
    template <class Add>
    Floats for_each_corner(Ints face, Add&& add) const {
        const auto* begins = reinterpret_cast<const std::int32_t*>(pass_.mesh().face_begin.data());
        const auto* corners = reinterpret_cast<const std::int32_t*>(pass_.mesh().corners.data());
        const Ints begin = gather(begins, face);
        const Ints count = gather(begins, face + Ints(1)) - begin;
        for (Ints k(0); any(k < count); k += Ints(1)) {
            const Mask has = k < count;
            add(gather(corners, begin + select(has, k, Ints(0))), has);
        }
        return floats_of(count);
    }

    /// The mean of the corners' vectors, added in their order.
    VectorLanes mean(const std::vector<float>& x, const std::vector<float>& y,
                     const std::vector<float>& z, Ints face) const {
        VectorLanes sum(Floats(0));
        const Floats count = for_each_corner(face, [&](Ints vertex, Mask has) {
            const VectorLanes corner(gather(x.data(), vertex), gather(y.data(), vertex),
                                     gather(z.data(), vertex));
            sum = shading::select(has, sum + corner, sum);
        });
        return {sum.x / count, sum.y / count, sum.z / count};
    }
    VectorLanes mean_corner(Ints face) const {
        const auto& points = pass_.vertices.points;
        return mean(points.x, points.y, points.z, face);
    }
    ColorLanes mean_color(Ints face) const {
        const auto& v = pass_.mesh().vertices;
        return mean(v.red, v.green, v.blue, face);
    }

    const ObjectPass& pass_;
};

/// Three attributes of a vector of pixels, and q behind them, times a power of two: see
/// `undivided`. All of them are multiples of the same power of two, which cancels out without a
/// rounding. Where there is no perspective, q is 1 and nothing is to be divided.
inline bool is_undivided(const Ints* a_q) {
    return all(a_q[3] == Ints(static_cast<std::int32_t>(raster::attribute_one)));
}
inline ColorLanes undivided_lanes(const Ints* a_q, float unit) {
    const Floats inverse = is_undivided(a_q) ? Floats(unit / raster::attribute_one)
                                             : Floats(unit) / floats_of(max(a_q[3], Ints(1)));
    return ColorLanes(floats_of(a_q[0]), floats_of(a_q[1]), floats_of(a_q[2])) * inverse;
}

/// Interpolated intensities: see `GouraudTechnique`.
class GouraudLanes {
public:
    static constexpr int attributes = 4;

    explicit GouraudLanes(const ObjectPass& pass) : pass_(pass), unit_(pass.unit) {}

    /// Of one step of an attribute: a power of two.
    float unit() const { return unit_ / raster::attribute_one; }

    ColorLanes shade(const PixelLanes& pixels) const { return color_of(pixels.attributes); }
    Floats opacity(const PixelLanes& pixels) const { return material_opacity(pass_, pixels); }
    ColorLanes color_of(const Ints* attributes) const { return undivided_lanes(attributes, unit_); }

private:
    const ObjectPass& pass_;
    float unit_;
};

/// `Frame::screen_at`.
inline VectorLanes screen_at(const PixelLanes& pixels) {
    return {floats_of(Ints(pixels.x) + iota()) + Floats(0.5f),
            Floats(static_cast<float>(pixels.y) + 0.5f),
            floats_of(pixels.depth) * Floats(raster::ndc_a_depth)};
}

/// What the pixels' faces have. Mostly it is one face: a fetch for each pixel takes much longer.
inline VectorLanes of_faces(const std::vector<glm::vec3>& vectors, const PixelLanes& pixels) {
    const Ints face = pixels.face();
    if (!pixels.is_one_face()) return gather(vectors, face);
    const glm::vec3& v = vectors[static_cast<std::size_t>(first_lane(face))];
    return {Floats(v.x), Floats(v.y), Floats(v.z)};
}

/// Of the side seen, world space.
inline VectorLanes face_normal(const ObjectPass& pass, const PixelLanes& pixels) {
    const VectorLanes normal = transformed_normal(pass.placing.normals_from_object,
                                                  of_faces(pass.mesh().face_normals, pixels));
    return shading::select(pixels.back(), -normal, normal);
}

/// The interpolated normal; where opposed ones cancel, the polygon's own.
inline VectorLanes normal_at(const ObjectPass& pass, const PixelLanes& pixels) {
    const VectorLanes n = pixels.vector(0);
    const VectorLanes normal = shading::unit_or(n, VectorLanes(Floats(0)));
    const Mask lost = pixels.shown & !(shading::dot(normal, normal) > Floats(0));
    return any(lost) ? shading::unit_or(n, face_normal(pass, pixels)) : normal;
}

/// Interpolated normals, lit pixel by pixel: see `PhongTechnique`.
template <class Model, Paint paint>
class PhongLanes {
public:
    static constexpr int attributes = paint == Paint::vertices ? 7 : 3;

    PhongLanes(const ObjectPass& pass, const Model& model) : pass_(pass), model_(model) {}

    ColorLanes shade(const PixelLanes& pixels) const {
        const VectorLanes point = point_at(pixels);
        const shading::Surface<Floats> surface{point, normal_at(pass_, pixels),
                                               view_from(pass_.frame->viewpoint, point)};
        return light_by_material(pass_, pixels.face(), pixels.shown, [&](const auto& material) {
            return illuminate(model_, surface,
                              painted_by<paint>(material, [&] { return vertex_color(pixels); }),
                              pass_.frame->lighting, Unshadowed{pixels.shadowed});
        });
    }

    Floats opacity(const PixelLanes& pixels) const { return material_opacity(pass_, pixels); }

private:
    VectorLanes point_at(const PixelLanes& pixels) const {
        return point_behind(pass_.frame->world_from_screen, screen_at(pixels));
    }

    VectorLanes vertex_color(const PixelLanes& pixels) const {
        return undivided_lanes(pixels.attributes + 3, 1.0f);
    }

    const ObjectPass& pass_;
    Model model_;
};

/// See `TexturedPhongTechnique`.
template <class Model>
class TexturedPhongLanes {
public:
    const int attributes;

    TexturedPhongLanes(const ObjectPass& pass, const Model& model)
        : attributes(pass.textured.count()), pass_(pass), model_(model) {}

    ColorLanes shade(const PixelLanes& pixels) const {
        const TexturedSurface<Floats> surface = surface_at(pixels);
        return by_material(materials(pixels), pixels.shown, [&](std::size_t number) {
            return illuminate_textured(model_, surface, pass_.object->materials[number],
                                       pass_.textures[number], *pass_.frame,
                                       Unshadowed{pixels.shadowed});
        });
    }
    Floats opacity(const PixelLanes& pixels) const {
        const TexturedSurface<Floats> surface = surface_at(pixels);
        const auto of_material = [&](std::size_t number) {
            return ColorLanes(
                opacity_on(pass_.object->materials[number], pass_.textures[number], surface.site));
        };
        return by_material(materials(pixels), pixels.shown, of_material).x;
    }

private:
    Ints materials(const PixelLanes& pixels) const {
        if (pass_.textures.size() == 1) return Ints(0);
        const auto& numbers = pass_.mesh().face_material;
        return gather(reinterpret_cast<const std::int32_t*>(numbers.data()), pixels.face());
    }

    TexturedSurface<Floats> surface_at(const PixelLanes& pixels) const {
        const glm::mat4& world_from_screen = pass_.frame->world_from_screen;
        const VectorLanes screen = screen_at(pixels);
        const VectorLanes point = point_behind(world_from_screen, screen);
        const auto steps =
            pixel_steps(world_from_screen, screen, point, face_normal(pass_, pixels));
        return {{point, normal_at(pass_, pixels), view_from(pass_.frame->viewpoint, point)},
                {point, own_place(pixels), steps.x, steps.y},
                color(pixels),
                select(pixels.back(), Floats(-1), Floats(1))};
    }

    ColorLanes color(const PixelLanes& pixels) const {
        if (!pass_.textured.has_colors) return ColorLanes(Floats(1));
        return undivided(pixels, pass_.textured.colors(), 3);
    }

    shading::TexturePlace<Floats> own_place(const PixelLanes& pixels) const {
        const VectorLanes nothing(Floats(0));
        if (!pass_.textured.has_uvs) return {Floats(0), Floats(0), nothing, nothing};
        const VectorLanes uv = undivided(pixels, pass_.textured.uvs(), 2);
        const glm::mat3& gradients = pass_.placing.normals_from_object;
        const auto gradient = [&](const std::vector<glm::vec3>& vectors) {
            return transformed_gradient(gradients, of_faces(vectors, pixels));
        };
        return {uv.x * Floats(pass_.uv_unit), uv.y * Floats(pass_.uv_unit),
                gradient(pass_.mesh().face_grad_u), gradient(pass_.mesh().face_grad_v)};
    }

    /// So many attributes from the `first` on, divided by q.
    ColorLanes undivided(const PixelLanes& pixels, int first, int count) const {
        const Ints* a = pixels.attributes;
        const Ints third = count == 3 ? a[first + 2] : Ints(0);
        const Ints a_q[4] = {a[first], a[first + 1], third, a[pass_.textured.q()]};
        return undivided_lanes(a_q, 1.0f);
    }

    const ObjectPass& pass_;
    Model model_;
};

/// Calls `use` with the technique that lights the object's pixels.
template <class Use>
decltype(auto) with_technique(const ObjectPass& pass, Use&& use) {
    if (pass.settings.shading == Shading::flat) return use(FlatLanes(pass));
    if (pass.settings.shading == Shading::gouraud) return use(GouraudLanes(pass));
    if (!pass.textures.empty()) {
        return with_model(pass.settings, [&](auto model) {
            return use(TexturedPhongLanes<decltype(model)>(pass, model));
        });
    }
    return with_model(pass.settings, [&](auto model) {
        return with_paint(pass.mesh(), [&](auto paint) {
            return use(PhongLanes<decltype(model), paint>(pass, model));
        });
    });
}

}  // namespace scanlight::render::HWY_NAMESPACE
