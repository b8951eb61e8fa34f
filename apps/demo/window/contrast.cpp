#include "apps/demo/window/contrast.h"

namespace scanlight::apps::window {

namespace {

raster::PackedPixel packed(std::span<const std::uint8_t> rgb) {
    return 0xff000000u | static_cast<raster::PackedPixel>(rgb[2]) << 16 |
           static_cast<raster::PackedPixel>(rgb[1]) << 8 | rgb[0];
}

Pixels pixels_of(const raster::Image8& image) {
    Pixels pixels({image.width(), image.height()}, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            pixels.at(x, y) = packed(image.pixel(x, y));
    }
    return pixels;
}

}  // namespace

Contrast contrast_of(const Pixels& left, const Pixels& right) {
    const raster::AnyImage first = image_of(left, raster::Alpha::dropped);
    const raster::AnyImage second = image_of(right, raster::Alpha::dropped);
    return {pixels_of(raster::difference_image(first, second)), raster::compare(first, second)};
}

}  // namespace scanlight::apps::window
