#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/lanes/attributes.h"
#include "raster/lanes/numbers.h"
#include "render/object_pass.h"
#include "render/shadow_band.h"
#include "render/transform.h"
#include "render/viewing.h"
#include "shading/whole.h"

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
    static Type sum_of_products(Type a, Type b) {
        return raster::HWY_NAMESPACE::sum_of_products(a, b);
    }
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

/// Calls `add(vertex, has)` with the corners of each lane's face in their order. Returns how many
/// each has.
template <class Add>
Floats for_each_corner(const mesh::Mesh& mesh, Ints face, Add&& add) {
    const auto* begins = reinterpret_cast<const std::int32_t*>(mesh.face_begin.data());
    const auto* corners = reinterpret_cast<const std::int32_t*>(mesh.corners.data());
    const Ints begin = gather(begins, face);
    const Ints count = gather(begins, face + Ints(1)) - begin;
    for (Ints k(0); any(k < count); k += Ints(1)) {
        const Mask has = k < count;
        add(gather(corners, begin + select(has, k, Ints(0))), has);
    }
    return floats_of(count);
}

/// Calls `use(number, lanes)` for each number among the wanted lanes, with those that have it. No
/// more than `most` of them: false if there are others.
template <class Use>
bool for_each_number(Ints of, Mask wanted, int most, Use&& use) {
    std::int32_t numbers[lane_count];
    store(of, numbers);
    std::uint32_t left = bits_of(wanted);
    for (int i = 0; i < most && left != 0; ++i) {
        const std::int32_t number = numbers[std::countr_zero(left)];
        const Mask same = of == Ints(number);
        use(number, same);
        left &= ~bits_of(same);
    }
    return left == 0;
}

/// Calls `light(number)` for the number of each material among the wanted lanes, and joins what
/// comes of it. Most vectors have one.
template <class Light>
ColorLanes by_material(Ints material, Mask wanted, Light&& light) {
    ColorLanes result(Floats(0));
    for_each_number(material, wanted, lane_count, [&](std::int32_t number, Mask same) {
        result = shading::select(same, light(static_cast<std::size_t>(number)), result);
    });
    return result;
}

/// `by_material` for an object, most of which have one material.
template <class Light>
ColorLanes light_by_number(const ObjectPass& pass, Ints face, Mask wanted, Light&& light) {
    if (pass.object->materials.size() == 1) return light(std::size_t{0});
    const auto* numbers = reinterpret_cast<const std::int32_t*>(pass.mesh().face_material.data());
    return by_material(gather(numbers, face), wanted, light);
}

/// The same, with the material itself.
template <class Light>
ColorLanes light_by_material(const ObjectPass& pass, Ints face, Mask wanted, Light&& light) {
    return light_by_number(pass, face, wanted, [&](std::size_t number) {
        return light(pass.object->materials[number]);
    });
}

/// Which polygons a vector of pixels shows.
struct FaceLanes {
    Mask shown;     // somewhere
    Ints item;      // where nothing is shown, that of a pixel where something is
    Ints shadowed;  // the lights that do not reach the pixel: their bits

    Ints face() const { return item & Ints(static_cast<std::int32_t>(raster::face_mask)); }
    Mask back() const { return item < Ints(0); }
};

/// A vector of pixels in a row.
struct PixelLanes : FaceLanes {
    int x, y;
    raster::PixelPlace place;  // of the first
    const SightRow* sight;     // of their row

    Ints depth() const { return load(place.depth); }
    Ints attribute(int k) const { return load(place.kept(k + 1)); }
    VectorLanes vector(int first) const {
        return {float_lanes(attribute(first)), float_lanes(attribute(first + 1)),
                float_lanes(attribute(first + 2))};
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

/// `Frame::screen_at`.
inline VectorLanes screen_at(const PixelLanes& pixels) {
    return {floats_of(Ints(pixels.x) + iota()) + Floats(0.5f),
            Floats(static_cast<float>(pixels.y) + 0.5f),
            floats_of(pixels.depth()) * Floats(raster::ndc_a_depth)};
}

/// `Frame::point_at`, where anybody asks for it.
inline VectorLanes point_at(const ObjectPass& pass, const PixelLanes& pixels) {
    if (!pass.needs_point) return VectorLanes(Floats(0));
    return point_behind(pass.frame->world_from_screen, screen_at(pixels));
}

/// `Frame::view_at`.
inline VectorLanes view_at(const PixelLanes& pixels) {
    return view_along(*pixels.sight, floats_of(Ints(pixels.x) + iota()) + Floats(0.5f));
}

/// Of the side seen, world space.
inline VectorLanes face_normal(const ObjectPass& pass, const PixelLanes& pixels) {
    const VectorLanes normal = transformed_normal(pass.placing.normals_from_object,
                                                  gather(pass.mesh().face_normals, pixels.face()));
    return shading::select(pixels.back(), -normal, normal);
}

/// The interpolated normal; where opposed ones cancel, the polygon's own.
inline VectorLanes normal_at(const ObjectPass& pass, const PixelLanes& pixels) {
    const VectorLanes n = pixels.vector(0);
    const Mask lost = pixels.shown & !shading::has_direction(n);
    return any(lost) ? shading::unit_or(n, face_normal(pass, pixels)) : shading::unit(n);
}

}  // namespace scanlight::render::HWY_NAMESPACE
