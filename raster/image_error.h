#pragma once

#include <stdexcept>
#include <string>

namespace scanlight::raster {

/// An image file that can't be read or written. `what()` reads "name: reason".
class ImageError : public std::runtime_error {
public:
    explicit ImageError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace scanlight::raster
