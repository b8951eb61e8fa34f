#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "raster/edge.h"
#include "raster/ramp.h"
#include "raster/vertex.h"

namespace scanlight::raster {

// Interpolation over a triangle by its plane: value(i, j) = origin + i dx + j dy, over pixels
// counted from a reference pixel, that of corner 0. Gradients are computed in double, in the order
// written here, and rounded to integers once; a vector of triangles that takes the same steps gets
// the same bits.
//
// With D the largest difference of values, E the largest difference of coordinates (sub-pixels) and
// A twice the area, both gradients are exact but for a few roundings: off by less than
// 2^-42 D E / A a pixel, before they are rounded.

/// A plane of depths in a ramp's format, 16 bits finer than depth itself.
struct DepthPlane {
    std::int64_t origin = 0;  // at the centre of the reference pixel
    std::int64_t dx = 0;
    std::int64_t dy = 0;

    /// Modulo 2^64: on a sliver i dx and j dy may each overflow, and cancel.
    std::int64_t at(int i, int j) const {
        return static_cast<std::int64_t>(
            static_cast<std::uint64_t>(origin) +
            static_cast<std::uint64_t>(i) * static_cast<std::uint64_t>(dx) +
            static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(dy));
    }
};

/// A plane of attributes in whole units, modulo 2^32: what is covered has values between those of
/// the corners, so that it comes out whole, however often the way there wrapped round.
struct AttributePlane {
    std::uint32_t origin = 0;
    std::uint32_t dx = 0;
    std::uint32_t dy = 0;

    std::uint32_t at(int i, int j) const {
        return origin + static_cast<std::uint32_t>(i) * dx + static_cast<std::uint32_t>(j) * dy;
    }
};

/// What every plane of one triangle shares.
struct PlaneSetup {
    double x1, y1, x2, y2;      // corners 1 and 2 relative to corner 0, in 1/256 pixel
    double inverse_area;        // pixels a unit of that area
    double offset_x, offset_y;  // from corner 0 to the reference pixel's centre, in pixels
};

inline double offset_to_centre(SubPixel c) {
    return static_cast<double>(half_pixel - (c & (subpixels - 1))) / subpixels;
}

/// The greatest extent of a triangle that has planes, in sub-pixels, for each unit of its area.
inline constexpr double thinnest = 32.0;
/// Gradients of depth a pixel, in a ramp's format, beyond which there is no plane.
inline constexpr double depth_gradient_limit = 2251799813685248.0;  // 2^51

/// None for a triangle of no area and for one less than 1/32 of a sub-pixel wide, whatever its
/// values: A > E / 32 bounds the gradients of any attribute (D < 2^32) by
///     2 D E 256 / A < 2^33 E 2^8 / A < 2^46,
/// and their error before rounding by 2^-42 2^32 32 = 1/32 unit a pixel.
inline std::optional<PlaneSetup> plane_setup(ScreenPoint a, ScreenPoint b, ScreenPoint c) {
    PlaneSetup s{};
    s.x1 = b.x - a.x;
    s.y1 = b.y - a.y;
    s.x2 = c.x - a.x;
    s.y2 = c.y - a.y;
    const double area = s.x1 * s.y2 - s.x2 * s.y1;  // below 2^45: exact
    const double extent = std::max(std::max(std::abs(s.x1), std::abs(s.y1)),
                                   std::max(std::abs(s.x2), std::abs(s.y2)));
    if (!(extent < thinnest * std::abs(area))) return std::nullopt;
    s.inverse_area = subpixels / area;
    s.offset_x = offset_to_centre(a.x);
    s.offset_y = offset_to_centre(a.y);
    return s;
}

/// Change of a value from one pixel to the next.
struct Gradient {
    double dx, dy;
};

inline Gradient gradient(const PlaneSetup& s, double v0, double v1, double v2) {
    const double d1 = v1 - v0;
    const double d2 = v2 - v0;
    return {(d1 * s.y2 - d2 * s.y1) * s.inverse_area, (d2 * s.x1 - d1 * s.x2) * s.inverse_area};
}

/// From corner 0 to the reference pixel's centre.
inline std::int64_t change_to_reference(const PlaneSetup& s, const Gradient& g) {
    return std::llrint(g.dx * s.offset_x + g.dy * s.offset_y);
}

/// None where a gradient does not fit its format. Off by at most 1/4 unit of depth on the largest
/// picture, for the rounding of the gradients, and by as much again before that (D = 2^46) on a
/// sliver of full depth that is 2^17 times as long as wide.
inline std::optional<DepthPlane> depth_plane(const PlaneSetup& s, Depth z0, Depth z1, Depth z2) {
    constexpr double scale = 1 << ramp_bits;
    const Gradient g = gradient(s, z0 * scale, z1 * scale, z2 * scale);
    if (!(std::abs(g.dx) < depth_gradient_limit && std::abs(g.dy) < depth_gradient_limit)) {
        return std::nullopt;
    }
    return DepthPlane{(std::int64_t{z0} << ramp_bits) + change_to_reference(s, g),
                      std::llrint(g.dx), std::llrint(g.dy)};
}

/// Off by at most 17/32 of a unit for each pixel between a place and the reference pixel, plus one.
inline AttributePlane attribute_plane(const PlaneSetup& s, Attribute v0, Attribute v1,
                                      Attribute v2) {
    const Gradient g = gradient(s, v0, v1, v2);
    return {static_cast<std::uint32_t>(v0 + change_to_reference(s, g)),
            static_cast<std::uint32_t>(std::llrint(g.dx)),
            static_cast<std::uint32_t>(std::llrint(g.dy))};
}

/// Interpolation over a triangle by its planes: within 0.009/255 of the bilinear rule on the
/// largest picture, at the price of one division a triangle instead of one a span. Integers
/// throughout: repeated addition and direct evaluation are the same bits.
template <int N>
class Planar {
public:
    struct EdgeValues {
        void step() {}
        void step(int) {}
    };

    /// None for triangles that have no setup or no plane of depths, whatever their attributes.
    /// Those are for `Bilinear`, which has no gradient across a sliver to overflow.
    static std::optional<Planar> of(std::span<const ScreenVertex<N>> triangle) {
        const auto& a = triangle[0];
        const auto& b = triangle[1];
        const auto& c = triangle[2];
        const auto setup = plane_setup({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        if (!setup) return std::nullopt;
        const auto depth = depth_plane(*setup, a.z, b.z, c.z);
        if (!depth) return std::nullopt;
        Planar planar;
        planar.reference_x_ = a.x >> subpixel_bits;
        planar.reference_y_ = a.y >> subpixel_bits;
        planar.depth_ = *depth;
        for (std::size_t k = 0; k < N; ++k) {
            planar.attributes_[k] =
                attribute_plane(*setup, a.attributes[k], b.attributes[k], c.attributes[k]);
        }
        return planar;
    }

    EdgeValues down(const ScreenVertex<N>&, const ScreenVertex<N>&, int) const { return {}; }

    Ramps<N> along(const Edge<EdgeValues>& left, const Edge<EdgeValues>&, int y) const {
        const int i = left.crossing.column() - reference_x_;
        const int j = y - reference_y_;
        Ramps<N> ramps;
        ramps.depth = {depth_.at(i, j), depth_.dx};
        for (std::size_t k = 0; k < N; ++k) {
            ramps.attributes[k] = {in_ramp(attributes_[k].at(i, j)), in_ramp(attributes_[k].dx)};
        }
        return ramps;
    }

private:
    /// Whole units in a ramp's format. What was known modulo 2^32 is so in the ramp's whole bits,
    /// which are all that `Ramp::get` looks at.
    static std::int64_t in_ramp(std::uint32_t units) {
        return std::int64_t{static_cast<std::int32_t>(units)} << ramp_bits;
    }

    int reference_x_ = 0;
    int reference_y_ = 0;
    DepthPlane depth_;
    std::array<AttributePlane, N> attributes_;
};

}  // namespace scanlight::raster
