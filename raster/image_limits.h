#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace scanlight::raster {

/// What a reader takes from a file; what the program draws itself may be larger.
inline constexpr std::int64_t max_image_side = 16384;
inline constexpr std::int64_t max_image_bytes = std::int64_t{256} << 20;

/// Of an image file: room for headers, and for what PNG adds to pixels that don't compress.
inline constexpr std::size_t max_file_bytes =
    static_cast<std::size_t>(max_image_bytes) + (std::size_t{16} << 20);

/// What the header of a file declares, before any of it is believed.
struct DeclaredSize {
    std::int64_t width;
    std::int64_t height;
    std::int64_t bytes_per_pixel;  // in memory
};

/// Throws ImageError "name: reason" when the picture has no pixels or passes the limits.
void require_within_limits(const std::string& name, const DeclaredSize& size);

}  // namespace scanlight::raster
