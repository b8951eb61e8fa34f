#pragma once

// Everything in this folder is compiled once for each vector instruction set (see `scanlight_lanes`
// in the top CMakeLists.txt), each time in a namespace of its own, and never included elsewhere.

#include <hwy/highway.h>

#include <bit>

#include <cstddef>
#include <cstdint>

namespace scanlight::raster::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;
using UnsignedTag = hn::ScalableTag<std::uint32_t>;
using DoubleTag = hn::ScalableTag<double>;
using LongTag = hn::ScalableTag<std::int64_t>;
using HalfIntTag = hn::Half<IntTag>;
using HalfFloatTag = hn::Half<FloatTag>;

/// Before a function: all that it calls becomes part of it, lest vectors travel through memory. Not
/// where a vector is an array anyway.
#if HWY_TARGET == HWY_EMU128
#define SCANLIGHT_FLATTEN
#else
#define SCANLIGHT_FLATTEN HWY_FLATTEN
#endif

/// How many numbers one vector holds.
inline constexpr int lane_count = static_cast<int>(hn::MaxLanes(FloatTag()));

/// A yes or no for each lane.
struct Mask {
    hn::Mask<FloatTag> m;
};

/// Floats side by side that behave like one: the number type of formulas written as templates.
struct Floats {
    hn::Vec<FloatTag> v;

    Floats() = default;
    Floats(hn::Vec<FloatTag> vector) : v(vector) {}
    explicit Floats(float value) : v(hn::Set(FloatTag(), value)) {}
    explicit Floats(double value) : Floats(static_cast<float>(value)) {}
    explicit Floats(int value) : Floats(static_cast<float>(value)) {}
};

/// 32-bit integers; sums and products wrap round.
struct Ints {
    hn::Vec<IntTag> v;

    Ints() = default;
    Ints(hn::Vec<IntTag> vector) : v(vector) {}
    explicit Ints(std::int32_t value) : v(hn::Set(IntTag(), value)) {}
};

/// Doubles take two vectors, 64-bit integers too.
struct Doubles {
    hn::Vec<DoubleTag> low, high;

    Doubles() = default;
    Doubles(hn::Vec<DoubleTag> l, hn::Vec<DoubleTag> h) : low(l), high(h) {}
    explicit Doubles(double value)
        : low(hn::Set(DoubleTag(), value)), high(hn::Set(DoubleTag(), value)) {}
};

struct Longs {
    hn::Vec<LongTag> low, high;
};

// ---- arithmetic

inline Floats operator+(Floats a, Floats b) {
    return hn::Add(a.v, b.v);
}
inline Floats operator-(Floats a, Floats b) {
    return hn::Sub(a.v, b.v);
}
inline Floats operator*(Floats a, Floats b) {
    return hn::Mul(a.v, b.v);
}
inline Floats operator/(Floats a, Floats b) {
    return hn::Div(a.v, b.v);
}
inline Floats operator-(Floats a) {
    return hn::Neg(a.v);
}
inline Floats& operator+=(Floats& a, Floats b) {
    return a = a + b;
}
inline Floats& operator*=(Floats& a, Floats b) {
    return a = a * b;
}

inline Ints operator+(Ints a, Ints b) {
    return hn::Add(a.v, b.v);
}
inline Ints operator-(Ints a, Ints b) {
    return hn::Sub(a.v, b.v);
}
inline Ints operator*(Ints a, Ints b) {
    return hn::Mul(a.v, b.v);
}
inline Ints operator&(Ints a, Ints b) {
    return hn::And(a.v, b.v);
}
inline Ints operator|(Ints a, Ints b) {
    return hn::Or(a.v, b.v);
}
inline Ints operator^(Ints a, Ints b) {
    return hn::Xor(a.v, b.v);
}
inline Ints& operator+=(Ints& a, Ints b) {
    return a = a + b;
}

inline Doubles operator+(Doubles a, Doubles b) {
    return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
inline Doubles operator-(Doubles a, Doubles b) {
    return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}
inline Doubles operator*(Doubles a, Doubles b) {
    return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
}
inline Doubles operator/(Doubles a, Doubles b) {
    return {hn::Div(a.low, b.low), hn::Div(a.high, b.high)};
}

inline Longs operator+(Longs a, Longs b) {
    return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
inline Longs operator-(Longs a, Longs b) {
    return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}

template <int bits>
Ints shift_left(Ints a) {
    return hn::ShiftLeft<bits>(a.v);
}
template <int bits>
Ints shift_right(Ints a) {
    return hn::ShiftRight<bits>(a.v);
}

/// Zeros come in at the other end.
inline Ints bits_moved_up(Ints a, int by) {
    return hn::ShiftLeftSame(a.v, by);
}
/// Rounded down.
inline Ints divided_by_power_of_two(Ints a, int by) {
    return hn::ShiftRightSame(a.v, by);
}
inline Ints bits_moved_down(Ints a, int by) {
    return hn::BitCast(IntTag(), hn::ShiftRightSame(hn::BitCast(UnsignedTag(), a.v), by));
}

// ---- comparisons

inline Mask operator<(Floats a, Floats b) {
    return {hn::Lt(a.v, b.v)};
}
inline Mask operator>(Floats a, Floats b) {
    return {hn::Gt(a.v, b.v)};
}
inline Mask operator<=(Floats a, Floats b) {
    return {hn::Le(a.v, b.v)};
}
inline Mask operator>=(Floats a, Floats b) {
    return {hn::Ge(a.v, b.v)};
}
inline Mask operator<(Ints a, Ints b) {
    return {hn::RebindMask(FloatTag(), hn::Lt(a.v, b.v))};
}
inline Mask operator>(Ints a, Ints b) {
    return {hn::RebindMask(FloatTag(), hn::Gt(a.v, b.v))};
}
inline Mask operator==(Ints a, Ints b) {
    return {hn::RebindMask(FloatTag(), hn::Eq(a.v, b.v))};
}
inline Mask operator!=(Ints a, Ints b) {
    return {hn::RebindMask(FloatTag(), hn::Ne(a.v, b.v))};
}
inline Mask operator&(Mask a, Mask b) {
    return {hn::And(a.m, b.m)};
}
inline Mask operator|(Mask a, Mask b) {
    return {hn::Or(a.m, b.m)};
}
inline Mask operator!(Mask a) {
    return {hn::Not(a.m)};
}

/// The lowest 32 bits.
inline Ints low_bits(Longs a) {
    const hn::ScalableTag<std::uint64_t> wide;
    const hn::Half<UnsignedTag> half;
    const auto narrow = hn::Combine(UnsignedTag(), hn::TruncateTo(half, hn::BitCast(wide, a.high)),
                                    hn::TruncateTo(half, hn::BitCast(wide, a.low)));
    return hn::BitCast(IntTag(), narrow);
}

/// Of wide numbers, as a mask of narrow ones.
inline Mask mask_of(hn::Vec<LongTag> low, hn::Vec<LongTag> high) {
    return {hn::RebindMask(FloatTag(), hn::MaskFromVec(low_bits({low, high}).v))};
}
inline hn::Vec<LongTag> wide_bits(hn::Mask<DoubleTag> mask) {
    return hn::BitCast(LongTag(), hn::VecFromMask(DoubleTag(), mask));
}
inline Mask operator<(Doubles a, Doubles b) {
    return mask_of(wide_bits(hn::Lt(a.low, b.low)), wide_bits(hn::Lt(a.high, b.high)));
}
inline Mask operator>(Doubles a, Doubles b) {
    return b < a;
}

inline hn::Mask<IntTag> int_mask(Mask mask) {
    return hn::RebindMask(IntTag(), mask.m);
}
inline bool any(Mask mask) {
    return !hn::AllFalse(FloatTag(), mask.m);
}
inline bool none(Mask mask) {
    return !any(mask);
}
inline bool all(Mask mask) {
    return hn::AllTrue(FloatTag(), mask.m);
}
inline int count(Mask mask) {
    return static_cast<int>(hn::CountTrue(FloatTag(), mask.m));
}
inline std::int32_t first_lane(Ints a) {
    return hn::GetLane(a.v);
}
/// The bits that any lane has.
inline std::int32_t joined_bits(Ints a) {
    std::int32_t lanes[lane_count];
    hn::StoreU(a.v, IntTag(), lanes);
    std::int32_t bits = 0;
    for (const std::int32_t lane : lanes)
        bits |= lane;
    return bits;
}
/// One bit a lane, the first lane's the lowest.
inline std::uint32_t bits_of(Mask mask) {
#if HWY_TARGET == HWY_AVX3
    return mask.m.raw;
#elif HWY_TARGET == HWY_AVX2
    return static_cast<std::uint32_t>(_mm256_movemask_ps(hn::VecFromMask(FloatTag(), mask.m).raw));
#else
    alignas(8) std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), mask.m, bytes);
    return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
#endif
}
/// The lanes before `n`.
inline Mask first_lanes(int n) {
    return {hn::FirstN(FloatTag(), static_cast<std::size_t>(n))};
}

inline Floats select(Mask condition, Floats yes, Floats no) {
    return hn::IfThenElse(condition.m, yes.v, no.v);
}
inline Ints select(Mask condition, Ints yes, Ints no) {
    return hn::IfThenElse(int_mask(condition), yes.v, no.v);
}

// ---- functions of numbers, named as formulas written for one number expect them

inline Ints min(Ints a, Ints b) {
    return hn::Min(a.v, b.v);
}
inline Ints max(Ints a, Ints b) {
    return hn::Max(a.v, b.v);
}
inline Floats min(Floats a, Floats b) {
    return hn::Min(a.v, b.v);
}
inline Doubles abs(Doubles a) {
    return {hn::Abs(a.low), hn::Abs(a.high)};
}
inline Ints abs(Ints a) {
    return hn::Abs(a.v);
}
inline Floats sqrt(Floats x) {
    return hn::Sqrt(x.v);
}

inline Floats floats_of(Ints a) {
    return hn::ConvertTo(FloatTag(), a.v);
}
/// Of numbers within 32 bits only, as `static_cast`: what else Highway's would mind takes four
/// instructions more.
inline Ints truncated(Floats a) {
#if HWY_TARGET == HWY_AVX3
    return hn::Vec<IntTag>{_mm512_cvttps_epi32(a.v.raw)};
#elif HWY_TARGET == HWY_AVX2
    return hn::Vec<IntTag>{_mm256_cvttps_epi32(a.v.raw)};
#elif HWY_TARGET == HWY_SSE4
    return hn::Vec<IntTag>{_mm_cvttps_epi32(a.v.raw)};
#else
    return hn::ConvertTo(IntTag(), a.v);
#endif
}
/// To the nearest, ties to even, as `std::lrint` does; the same numbers.
inline Ints nearest(Floats a) {
#if HWY_TARGET == HWY_AVX3
    return hn::Vec<IntTag>{_mm512_cvtps_epi32(a.v.raw)};
#elif HWY_TARGET == HWY_AVX2
    return hn::Vec<IntTag>{_mm256_cvtps_epi32(a.v.raw)};
#elif HWY_TARGET == HWY_SSE4
    return hn::Vec<IntTag>{_mm_cvtps_epi32(a.v.raw)};
#else
    return hn::NearestInt(a.v);
#endif
}
inline Floats floor(Floats x) {
    return hn::Floor(x.v);
}
inline Ints bits_of(Floats a) {
    return hn::BitCast(IntTag(), a.v);
}
inline Floats floats_from_bits(Ints a) {
    return hn::BitCast(FloatTag(), a.v);
}

/// `scanlight::shading::nearest_whole`.
inline Floats nearest_whole(Floats x) {
    const Floats last_bit_is_one(0x1.8p23f);
    return (x + last_bit_is_one) - last_bit_is_one;
}
inline Floats power_of_two(Floats exponent) {
    return floats_from_bits(shift_left<23>(truncated(exponent) + Ints(127)));
}
struct SplitFloats {
    Floats mantissa;
    Floats exponent;
};
inline SplitFloats split(Floats x) {
    const Ints lowest = bits_of(Floats(0.70710678118654752440f));
    const Ints exponent = shift_right<23>(bits_of(x) - lowest);
    return {floats_from_bits(bits_of(x) - shift_left<23>(exponent)), floats_of(exponent)};
}

// ---- between narrow and wide

inline Doubles doubles_of(Ints a) {
    const HalfIntTag half;
    const DoubleTag wide;
    return {hn::PromoteTo(wide, hn::LowerHalf(half, a.v)),
            hn::PromoteTo(wide, hn::UpperHalf(half, a.v))};
}
inline Doubles doubles_of(Floats a) {
    const HalfFloatTag half;
    const DoubleTag wide;
    return {hn::PromoteTo(wide, hn::LowerHalf(half, a.v)),
            hn::PromoteTo(wide, hn::UpperHalf(half, a.v))};
}
inline Floats floats_of(Doubles a) {
    const HalfFloatTag half;
    return hn::Combine(FloatTag(), hn::DemoteTo(half, a.high), hn::DemoteTo(half, a.low));
}
/// To the nearest, ties to even, as `std::llrint` does; for |a| < 2^51. The sum's last bit is 1.
inline Longs nearest(Doubles a) {
    const Doubles shifted = a + Doubles(0x1.8p52);
    const auto zero = hn::Set(LongTag(), 0x4338000000000000);
    return {hn::Sub(hn::BitCast(LongTag(), shifted.low), zero),
            hn::Sub(hn::BitCast(LongTag(), shifted.high), zero)};
}
// ---- memory

inline Ints iota() {
    return hn::Iota(IntTag(), 0);
}
inline Ints load(const std::int32_t* from) {
    return hn::LoadU(IntTag(), from);
}
inline Floats load(const float* from) {
    return hn::LoadU(FloatTag(), from);
}
inline void store(Ints a, std::int32_t* to) {
    hn::StoreU(a.v, IntTag(), to);
}
inline void store(Floats a, float* to) {
    hn::StoreU(a.v, FloatTag(), to);
}
inline void store(Longs a, std::int64_t* to) {
    hn::StoreU(a.low, LongTag(), to);
    hn::StoreU(a.high, LongTag(), to + lane_count / 2);
}
inline Ints gather(const std::int32_t* base, Ints index) {
    return hn::GatherIndex(IntTag(), base, index.v);
}
/// Of two signed 16-bit numbers in each: that of the low ones plus that of the high ones.
inline Ints sum_of_products(Ints a, Ints b) {
    const IntTag whole;
    const hn::Repartition<std::int16_t, IntTag> halves;
    auto some = hn::Zero(whole);
    const auto others = hn::ReorderWidenMulAccumulate(whole, hn::BitCast(halves, a.v),
                                                      hn::BitCast(halves, b.v), some, some);
    return Ints(hn::RearrangeToOddPlusEven(others, some));
}
struct IntPairs {
    Ints first, second;
};
/// base[2 index] and the one behind it. Both of a lane are fetched at once where that is one
/// instruction for several lanes: the time goes by the fetches.
inline IntPairs gather_pairs(const std::int32_t* base, Ints index) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
    const HalfIntTag half;
    const auto* pairs = reinterpret_cast<const std::int64_t*>(base);  // never read as such by C++
    const auto fetched = [&](auto indices) {
        const auto wide = hn::GatherIndex(LongTag(), pairs, hn::PromoteTo(LongTag(), indices));
        return hn::BitCast(IntTag(), wide);
    };
    const auto low = fetched(hn::LowerHalf(half, index.v));
    const auto high = fetched(hn::UpperHalf(half, index.v));
    return {hn::ConcatEven(IntTag(), high, low), hn::ConcatOdd(IntTag(), high, low)};
#else
    const Ints first = index + index;
    return {gather(base, first), gather(base + 1, first)};
#endif
}
inline Floats gather(const float* base, Ints index) {
    return hn::GatherIndex(FloatTag(), base, index.v);
}
/// Leaves the other lanes of memory alone; they may be read and written back, by one thread.
inline void store_where(Mask where, Ints a, std::int32_t* to) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
    hn::BlendedStore(a.v, int_mask(where), IntTag(), to);
#else
    store(select(where, a, load(to)), to);
#endif
}

}  // namespace scanlight::raster::HWY_NAMESPACE
