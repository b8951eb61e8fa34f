#include "render/texture_image.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "raster/srgb.h"

namespace scanlight::render {

namespace {

float linear(std::uint8_t sample, TexelMeaning meaning) {
    return meaning == TexelMeaning::color ? raster::linear_from_srgb(sample)
                                          : static_cast<float>(sample) / 255.0f;
}
/// Between the colours of the two bytes that 16 bits lie between.
float linear(std::uint16_t sample, TexelMeaning meaning) {
    if (meaning == TexelMeaning::value) return static_cast<float>(sample) / 65535.0f;
    const auto below = static_cast<std::uint8_t>(sample / 257);
    const auto rest = static_cast<float>(sample % 257) / 257.0f;
    const float low = raster::linear_from_srgb(below);
    if (below == 255) return low;
    return low + (raster::linear_from_srgb(static_cast<std::uint8_t>(below + 1)) - low) * rest;
}
float linear(float sample, TexelMeaning) {
    return sample;
}

template <class Sample>
void append_texel(std::span<const Sample> pixel, TexelMeaning meaning, std::vector<float>& rgba) {
    const bool is_grey = pixel.size() < 3;
    const bool has_alpha = pixel.size() % 2 == 0;
    for (std::size_t c = 0; c < 3; ++c)
        rgba.push_back(linear(pixel[is_grey ? 0 : c], meaning));
    rgba.push_back(has_alpha ? linear(pixel.back(), TexelMeaning::value) : 1.0f);
}

template <class Sample>
std::vector<float> texels(const raster::Image<Sample>& image, TexelMeaning meaning,
                          RowAtZero zero) {
    std::vector<float> rgba;
    rgba.reserve(4 * static_cast<std::size_t>(image.width()) *
                 static_cast<std::size_t>(image.height()));
    for (int row = 0; row < image.height(); ++row) {
        const int y = zero == RowAtZero::highest ? row : image.height() - 1 - row;
        for (int x = 0; x < image.width(); ++x)
            append_texel(image.pixel(x, y), meaning, rgba);
    }
    return rgba;
}

}  // namespace

std::shared_ptr<const shading::TexelImage> texel_image(const raster::AnyImage& image,
                                                       TexelMeaning meaning, RowAtZero zero) {
    return std::visit(
        [&](const auto& pixels) -> std::shared_ptr<const shading::TexelImage> {
            const std::int64_t count = std::int64_t{pixels.width()} * pixels.height();
            if (count > most_texels) return nullptr;
            return std::make_shared<const shading::TexelImage>(pixels.width(), pixels.height(),
                                                               texels(pixels, meaning, zero));
        },
        image);
}

}  // namespace scanlight::render
