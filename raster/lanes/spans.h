#pragma once

#include <algorithm>

#include "raster/fixed.h"
#include "raster/lanes/keep.h"
#include "raster/lanes/numbers.h"
#include "raster/ramp.h"
#include "raster/visible_band.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// The values of a ramp at as many pixels as there are lanes. A ramp carries 16 fraction bits in 64
/// bits; here its whole part and its fraction go apart, in 32 bits each. The fractions are added up
/// without carrying over: over a whole row of 16384 pixels they stay below 2^31.
/// The same bits as `Ramp::get` after as many `Ramp::step`s.
class RampLanes {
public:
    RampLanes() = default;
    /// The first lane is `value`, each one on the right more by `dx`; a step adds `step`.
    RampLanes(std::int64_t value, std::int64_t dx, std::int64_t step)
        : whole_(Ints(whole(value)) + iota() * Ints(whole(dx))),
          fraction_(Ints(fraction(value) + half) + iota() * Ints(fraction(dx))),
          whole_step_(whole(step)),
          fraction_step_(fraction(step)) {}

    /// Steps along a row, a vector at a time, from so many pixels before the ramp begins.
    RampLanes(const Ramp& ramp, int before)
        : RampLanes(plus(ramp.value, times(ramp.step_size, -before)), ramp.step_size,
                    times(ramp.step_size, lane_count)) {}

    Ints get() const { return whole_ + shift_right<ramp_bits>(fraction_); }

    void step() {
        whole_ += whole_step_;
        fraction_ += fraction_step_;
    }

private:
    static constexpr std::int32_t half = 1 << (ramp_bits - 1);
    // Modulo 2^64, as all ramps are.
    static std::int64_t times(std::int64_t step, int count) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(step) *
                                         static_cast<std::uint64_t>(count));
    }
    static std::int64_t plus(std::int64_t a, std::int64_t b) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) +
                                         static_cast<std::uint64_t>(b));
    }
    static std::int32_t whole(std::int64_t v) { return static_cast<std::int32_t>(v >> ramp_bits); }
    static std::int32_t fraction(std::int64_t v) { return static_cast<std::int32_t>(v & 0xffff); }

    Ints whole_;
    Ints fraction_;
    Ints whole_step_;
    Ints fraction_step_;
};

/// `Ramp::get` after so many steps, modulo 2^64 as all ramps are.
inline std::int32_t ramp_at(const Ramp& ramp, int steps) {
    const auto bits = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    const std::uint64_t value =
        bits(ramp.value) + static_cast<std::uint64_t>(steps) * bits(ramp.step_size);
    return static_cast<std::int32_t>((value + bits(Ramp::half)) >> ramp_bits);
}

/// The ramps of N attributes, see `RampLanes`.
template <int N>
class RampValues {
public:
    RampValues(const Ramp* ramps, int before) {
        for (int k = 0; k < N; ++k)
            ramps_[k] = RampLanes(ramps[k], before);
    }
    void get(Ints* to) const {
        for (int k = 0; k < N; ++k)
            to[k] = ramps_[k].get();
    }
    void step() {
        for (int k = 0; k < N; ++k)
            ramps_[k].step();
    }

private:
    RampLanes ramps_[N + 1];
};

/// Where the first vector of the pixels [x_begin, x_end) begins: with a line of the cache, so that
/// each vector lies within one; or at x_begin, where one vector then holds them all and else not.
inline int first_vector(int x_begin, int x_end) {
    const int line = x_begin & -lane_count;
    const bool one_suffices = x_end - x_begin <= lane_count;
    return one_suffices && x_end - line > lane_count ? x_begin : line;
}

/// Draws pixels [x_begin, x_end) of a row whose first pixel is `row`; `z` and `values` begin at
/// first_vector(x_begin, x_end) and step along it: to copy them would take longer than many a span.
/// Returns how many passed.
template <class Keep, class Values>
std::size_t draw_span(PixelPlace row, int x_begin, int x_end, RampLanes& z, Values& values,
                      const Keep& keep, Ints own) {
    std::size_t passed = 0;
    int x = first_vector(x_begin, x_end);
    const auto draw = [&](Mask covered) {
        passed +=
            static_cast<std::size_t>(store_nearer(covered, z.get(), keep, own, values, row + x));
        x += lane_count;
        z.step();
        values.step();
    };
    const auto before = [&](int x_limit) { return first_lanes(std::min(x_limit - x, lane_count)); };
    draw(before(x_end) & !before(x_begin));
    while (x + lane_count <= x_end)
        draw(first_lanes(lane_count));
    if (x < x_end) draw(before(x_end));
    return passed;
}

}  // namespace scanlight::raster::HWY_NAMESPACE
