#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "raster/image.h"

namespace scanlight::apps {

using Color8 = std::array<std::uint8_t, 3>;  // sRGB

/// Fills columns [x, x + width) and rows [y, y + height), as far as they are in the picture.
void fill_box(raster::Image8& picture, int x, int y, int width, int height, const Color8& color);

/// Writes a line of ASCII text, 7 pixels high, from (x, y) on.
void write_text(raster::Image8& picture, int x, int y, const std::string& text,
                const Color8& color);

/// In pixels.
int text_width(const std::string& text);

}  // namespace scanlight::apps
