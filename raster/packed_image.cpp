#include "raster/packed_image.h"

namespace scanlight::raster {

Plane<PackedPixel> packed_image(const Image8& image) {
    Plane<PackedPixel> packed({image.width(), image.height()}, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto rgb = image.pixel(x, y);
            packed.at(x, y) =
                0xff000000u | PackedPixel{rgb[2]} << 16 | PackedPixel{rgb[1]} << 8 | rgb[0];
        }
    }
    return packed;
}

}  // namespace scanlight::raster
