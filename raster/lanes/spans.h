#pragma once

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

    /// Steps along a row, a vector at a time.
    explicit RampLanes(const Ramp& ramp)
        : RampLanes(ramp.value, ramp.step_size, times_lanes(ramp.step_size)) {}

    Ints get() const { return whole_ + shift_right<ramp_bits>(fraction_); }

    void step() {
        whole_ += whole_step_;
        fraction_ += fraction_step_;
    }

private:
    static constexpr std::int32_t half = 1 << (ramp_bits - 1);
    /// Modulo 2^64, as all ramps are.
    static std::int64_t times_lanes(std::int64_t step) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(step) * lane_count);
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
    explicit RampValues(const Ramp* ramps) {
        for (int k = 0; k < N; ++k)
            ramps_[k] = RampLanes(ramps[k]);
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

/// Draws pixels [x_begin, x_end) of a row whose first pixel is `row`; `z` and `values` begin at
/// x_begin and step along it: to copy them would take longer than many a span. Returns how many
/// passed.
template <class Keep, class Values>
std::size_t draw_span(PixelPlace row, int x_begin, int x_end, RampLanes& z, Values& values,
                      const Keep& keep, Ints own) {
    const Mask whole = first_lanes(lane_count);
    std::size_t passed = 0;
    int x = x_begin;
    for (; x + lane_count <= x_end; x += lane_count, z.step(), values.step()) {
        passed +=
            static_cast<std::size_t>(store_nearer(whole, z.get(), keep, own, values, row + x));
    }
    if (x < x_end) {
        passed += static_cast<std::size_t>(
            store_nearer(first_lanes(x_end - x), z.get(), keep, own, values, row + x));
    }
    return passed;
}

}  // namespace scanlight::raster::HWY_NAMESPACE
