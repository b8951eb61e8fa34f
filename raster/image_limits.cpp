#include "raster/image_limits.h"

#include "raster/image_error.h"

namespace scanlight::raster {

namespace {

std::string text(const DeclaredSize& size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels";
}

}  // namespace

void require_within_limits(const std::string& name, const DeclaredSize& size) {
    if (size.width < 1 || size.height < 1) {
        throw ImageError(name + ": " + text(size) + ": there is nothing in it");
    }
    if (size.width > max_image_side || size.height > max_image_side) {
        throw ImageError(name + ": " + text(size) + ": a side is longer than " +
                         std::to_string(max_image_side));
    }
    if (size.width * size.height * size.bytes_per_pixel > max_image_bytes) {
        throw ImageError(name + ": " + text(size) + " take more than " +
                         std::to_string(max_image_bytes >> 20) + " MiB");
    }
}

}  // namespace scanlight::raster
