#include "raster/develop.h"

#include <algorithm>

#include "raster/image_of.h"
#include "raster/packed.h"
#include "raster/srgb.h"

namespace scanlight::raster {

namespace {

int channels(Alpha alpha) {
    return alpha == Alpha::kept ? 4 : 3;
}

}  // namespace

ImageF linear_image(const Plane<Rgba>& color, Alpha alpha) {
    return image_of<float>(color, channels(alpha), [](std::span<float> pixel, const Rgba& c) {
        for (std::size_t k = 0; k < pixel.size(); ++k)
            pixel[k] = c[static_cast<int>(k)];
    });
}

Image8 srgb_image(const Plane<Rgba>& color, Alpha alpha) {
    return image_of<std::uint8_t>(
        color, channels(alpha), [](std::span<std::uint8_t> pixel, const Rgba& c) {
            for (int k = 0; k < 3; ++k)
                pixel[static_cast<std::size_t>(k)] = srgb_from_linear(c[k]);
            if (pixel.size() == 4) pixel[3] = step_of_255(c.a);
        });
}

Image16 depth_image(const Plane<Depth>& depth) {
    return image_of<std::uint16_t>(depth, 1, [](std::span<std::uint16_t> pixel, Depth z) {
        pixel[0] = static_cast<std::uint16_t>(std::min(z >> 14, 65535));
    });
}

}  // namespace scanlight::raster
