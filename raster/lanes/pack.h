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

inline Ints linear_byte_lanes(Floats intensity) {
    const Floats low(0);
    const Floats high(1);
    const Floats clamped =
        select(intensity >= low, select(intensity <= high, intensity, high), low);
    return nearest(clamped * Floats(255.0f));
}

/// `packed_pixel` of opaque colours.
template <Encoding encoding>
Ints pack_lanes(Floats red, Floats green, Floats blue) {
    const auto byte = [](Floats x) {
        return encoding == Encoding::srgb ? srgb_lanes(x) : linear_byte_lanes(x);
    };
    return byte(red) | shift_left<8>(byte(green)) | shift_left<16>(byte(blue)) |
           Ints(static_cast<std::int32_t>(0xff000000u));
}

}  // namespace scanlight::raster::HWY_NAMESPACE
