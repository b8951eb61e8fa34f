#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scanlight::raster {

using Bytes = std::vector<std::uint8_t>;

/// The bytes of an image file, with the name that messages about it give.
struct EncodedImage {
    std::string name;
    Bytes bytes;
};

}  // namespace scanlight::raster
