#pragma once

#include "raster/fixed.h"
#include "raster/lanes/numbers.h"
#include "raster/packed.h"
#include "raster/srgb.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// `srgb_from_linear`.
inline Ints srgb_lanes(Floats linear) {
    const Floats begin(first_srgb_cell);
    const Floats one(1);
    const Mask in_cells = (linear >= begin) & (linear < one);
    const Ints offset = bits_of(select(in_cells, linear, begin)) - bits_of(begin);
    const Ints cell = gather(srgb_cells.data(), shift_right<16>(offset));
    const Ints first = shift_right<17>(cell);
    const Ints step = cell & Ints(0x1ffff);
    const Ints value = select((offset & Ints(0xffff)) < step, first, first + Ints(1));
    return select(in_cells, value, select(linear >= one, Ints(255), Ints(0)));
}

/// The whole number nearest to `steps`, at most 255, in the lowest bits of a sum with 2^23, to even
/// in a tie; the bits above are those of 2^23.
inline Ints byte_over_2_23(Floats steps) {
    return bits_of(min(steps, Floats(255)) + Floats(0x1p23f));
}
/// The nearest of 255 equal steps, so. A NaN is 0.
inline Ints linear_byte_over_2_23(Floats intensity) {
    const Floats positive = select(intensity > Floats(0), intensity, Floats(0));
    return byte_over_2_23(positive * Floats(255.0f));
}

/// Bytes below a number that is the same for all pixels and cancels out.
inline Ints packed_bytes(Ints red, Ints green, Ints blue, std::uint32_t rest) {
    return red + shift_left<8>(green) + shift_left<16>(blue) +
           Ints(static_cast<std::int32_t>(rest));
}
/// Opaque, of three bytes each over 2^23.
inline Ints packed_over_2_23(Ints red, Ints green, Ints blue) {
    constexpr std::uint32_t over = 0x4b000000u;  // the bits of 2^23, in each of three bytes' places
    constexpr std::uint32_t opaque = 0xff000000u;
    return packed_bytes(red, green, blue, opaque - over - (over << 8) - (over << 16));
}

/// `pack_lanes<Encoding::linear>` of three channels that are multiples of `unit`, a power of two.
inline Ints pack_linear_multiples(const Ints* channels, float unit) {
    const Floats steps(255.0f * unit);
    const auto byte = [&](Ints channel) {
        return byte_over_2_23(floats_of(max(channel, Ints(0))) * steps);
    };
    return packed_over_2_23(byte(channels[0]), byte(channels[1]), byte(channels[2]));
}

/// `packed_pixel` of opaque colours.
template <Encoding encoding>
Ints pack_lanes(Floats red, Floats green, Floats blue) {
    if constexpr (encoding == Encoding::srgb)
        return packed_bytes(srgb_lanes(red), srgb_lanes(green), srgb_lanes(blue), 0xff000000u);
    return packed_over_2_23(linear_byte_over_2_23(red), linear_byte_over_2_23(green),
                            linear_byte_over_2_23(blue));
}

}  // namespace scanlight::raster::HWY_NAMESPACE
