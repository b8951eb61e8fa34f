#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "raster/edge.h"
#include "raster/ramp.h"
#include "raster/vertex.h"

namespace scanlight::raster {

/// value(i, j) = origin + i dx + j dy over pixels: one set of increments for a whole triangle.
struct PlaneEquation {
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

/// A triangle's plane set-up: what every plane equation of it shares.
struct PlaneSetup {
    double x1, y1, x2, y2;      // corners 1 and 2 relative to corner 0, in 1/256 pixel
    double inverse_area;        // pixels a unit of that area
    double offset_x, offset_y;  // from corner 0 to the reference pixel's centre, in pixels
};

/// Interpolation over a triangle by its plane: within 0.008/255 of the bilinear rule on the largest
/// picture, at the price of one division a triangle instead of one a span. With gradients rounded
/// to the number format, an attribute is off by at most half a unit for each pixel between it and
/// the reference pixel, plus one; depth, whose gradients keep 16 more bits, by half a unit.
/// Integers throughout: repeated addition and direct evaluation are the same bits.
template <int N>
class Planar {
public:
    struct EdgeValues {
        void step() {}
    };

    /// None for a triangle of no area, and for slivers whose gradients pass the number formats:
    /// those are for `Bilinear`, which has no gradient across a sliver to overflow.
    static std::optional<Planar> of(std::span<const ScreenVertex<N>> triangle) {
        const auto setup = setup_of(triangle);
        if (!setup) return std::nullopt;
        Planar planar;
        planar.reference_x_ = triangle[0].x >> subpixel_bits;
        planar.reference_y_ = triangle[0].y >> subpixel_bits;
        bool fits = planar.fit_depth(triangle, *setup);
        for (std::size_t k = 0; k < N; ++k)
            fits = fits && planar.fit_attribute(triangle, *setup, k);
        return fits ? std::optional(planar) : std::nullopt;
    }

    EdgeValues down(const ScreenVertex<N>&, const ScreenVertex<N>&, int) const { return {}; }

    Ramps<N> along(const Edge<EdgeValues>& left, const Edge<EdgeValues>&, int y) const {
        const int i = left.crossing.column() - reference_x_;
        const int j = y - reference_y_;
        Ramps<N> ramps;
        ramps.depth = {depth_.at(i, j), depth_.dx};
        for (std::size_t k = 0; k < N; ++k) {
            ramps.attributes[k] = {attributes_[k].at(i, j), attributes_[k].dx};
        }
        return ramps;
    }

private:
    // Gradients a pixel beyond these do not fit: attributes step in 32 bits, depth in 52.
    static constexpr double attribute_gradient_limit = 2147483647.0;
    static constexpr double depth_gradient_limit = 2251799813685248.0;  // 2^51

    static std::optional<PlaneSetup> setup_of(std::span<const ScreenVertex<N>> t) {
        PlaneSetup s{};
        s.x1 = t[1].x - t[0].x;
        s.y1 = t[1].y - t[0].y;
        s.x2 = t[2].x - t[0].x;
        s.y2 = t[2].y - t[0].y;
        const double area = s.x1 * s.y2 - s.x2 * s.y1;  // below 2^47: exact
        if (area == 0.0) return std::nullopt;
        s.inverse_area = subpixels / area;
        s.offset_x = offset_to_centre(t[0].x);
        s.offset_y = offset_to_centre(t[0].y);
        return s;
    }

    static double offset_to_centre(SubPixel c) {
        return static_cast<double>(half_pixel - (c & (subpixels - 1))) / subpixels;
    }

    static std::optional<PlaneEquation> equation(const PlaneSetup& s, double v0, double v1,
                                                 double v2, double limit) {
        // Products of a difference of values and one of coordinates are below 2^53, so they and
        // their difference are exact, and a sliver's gradient suffers no cancellation.
        const double d1 = v1 - v0;
        const double d2 = v2 - v0;
        const double dx = (d1 * s.y2 - d2 * s.y1) * s.inverse_area;
        const double dy = (d2 * s.x1 - d1 * s.x2) * s.inverse_area;
        if (!(std::abs(dx) < limit && std::abs(dy) < limit)) return std::nullopt;
        return PlaneEquation{
            static_cast<std::int64_t>(v0) + std::llrint(dx * s.offset_x + dy * s.offset_y),
            std::llrint(dx), std::llrint(dy)};
    }

    bool fit_depth(std::span<const ScreenVertex<N>> t, const PlaneSetup& s) {
        constexpr double scale = 1 << ramp_bits;
        const auto fitted =
            equation(s, t[0].z * scale, t[1].z * scale, t[2].z * scale, depth_gradient_limit);
        if (fitted) depth_ = *fitted;
        return fitted.has_value();
    }

    bool fit_attribute(std::span<const ScreenVertex<N>> t, const PlaneSetup& s, std::size_t k) {
        const auto fitted = equation(s, t[0].attributes[k], t[1].attributes[k], t[2].attributes[k],
                                     attribute_gradient_limit);
        if (!fitted) return false;
        constexpr std::int64_t scale = 1 << ramp_bits;  // whole units, in a ramp's format
        attributes_[k] = {fitted->origin * scale, fitted->dx * scale, fitted->dy * scale};
        return true;
    }

    int reference_x_ = 0;
    int reference_y_ = 0;
    PlaneEquation depth_;
    std::array<PlaneEquation, N> attributes_;
};

}  // namespace scanlight::raster
