#include "render/image_channel.h"

#include <cstddef>
#include <variant>

namespace scanlight::render {

namespace {

/// Its place in a pixel of so many channels.
std::size_t place_of(ImageChannel channel, int channels) {
    const bool is_grey = channels < 3;
    if (channel == ImageChannel::alpha) return static_cast<std::size_t>(channels - 1);
    if (channel == ImageChannel::green && !is_grey) return 1;
    if (channel == ImageChannel::blue && !is_grey) return 2;
    return 0;
}

template <class Sample>
raster::Image<Sample> picked(const raster::Image<Sample>& image, std::size_t place) {
    raster::Image<Sample> grey(image.width(), image.height(), 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            grey.pixel(x, y)[0] = image.pixel(x, y)[place];
    }
    return grey;
}

}  // namespace

raster::AnyImage channel_of(const raster::AnyImage& image, ImageChannel channel) {
    const auto pick = [&](const auto& pixels) -> raster::AnyImage {
        const bool has_alpha = pixels.channels() % 2 == 0;
        const bool is_whole =
            channel == ImageChannel::luminance || (channel == ImageChannel::alpha && !has_alpha);
        if (is_whole) return pixels;
        return picked(pixels, place_of(channel, pixels.channels()));
    };
    return std::visit(pick, image);
}

}  // namespace scanlight::render
