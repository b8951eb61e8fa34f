#pragma once

#include <cstdint>

namespace scanlight::mesh {

/// Linear light, 0 to 1, of an 8-bit sRGB value (IEC 61966-2-1). Same bits everywhere: the table
/// is computed by the compiler, of + - x / only. `raster` has such a table too, for it decodes
/// pictures: the rooms are strangers, and a standard's formula is no reason to make them meet.
float linear_from_srgb(std::uint8_t value_srgb);

}  // namespace scanlight::mesh
