#include "shading/texel_image.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace scanlight::shading {

namespace {

constexpr std::size_t channels = 4;

struct Texels {
    int width, height;
    std::vector<float> rgba;

    const float* at(int x, int y) const {
        return rgba.data() +
               channels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x));
    }
};

/// What a texel of the smaller side covers of the larger one: from `begin`, whole texels but for
/// the first and the last.
struct Cover {
    int begin, end;
    double first, last;  // their shares

    double share(int i) const { return i == begin ? first : i == end - 1 ? last : 1.0; }
};

Cover cover_of(int i, int smaller, int larger) {
    const double scale = static_cast<double>(larger) / smaller;
    const double from = i * scale;
    const double to = i == smaller - 1 ? larger : (i + 1) * scale;
    const int begin = static_cast<int>(from);
    const int end = static_cast<int>(std::ceil(to));
    return {begin, end, begin + 1 - from, to - (end - 1)};
}

/// The mean over the area that each texel covers.
void average(const Texels& from, const Cover& columns, const Cover& rows, float* to) {
    double sum[channels] = {};
    double area = 0;
    for (int y = rows.begin; y < rows.end; ++y) {
        for (int x = columns.begin; x < columns.end; ++x) {
            const double share = rows.share(y) * columns.share(x);
            area += share;
            for (std::size_t c = 0; c < channels; ++c)
                sum[c] += share * static_cast<double>(from.at(x, y)[c]);
        }
    }
    for (std::size_t c = 0; c < channels; ++c)
        to[c] = static_cast<float>(sum[c] / area);
}

Texels halved(const Texels& from) {
    Texels to{std::max(1, from.width / 2), std::max(1, from.height / 2), {}};
    to.rgba.resize(channels * static_cast<std::size_t>(to.width) *
                   static_cast<std::size_t>(to.height));
    float* texel = to.rgba.data();
    for (int y = 0; y < to.height; ++y) {
        const Cover rows = cover_of(y, to.height, from.height);
        for (int x = 0; x < to.width; ++x, texel += channels)
            average(from, cover_of(x, to.width, from.width), rows, texel);
    }
    return to;
}

std::int32_t word_of(float low, float high) {
    const auto bits = static_cast<std::uint32_t>(half_from_float(low)) |
                      static_cast<std::uint32_t>(half_from_float(high)) << 16;
    return static_cast<std::int32_t>(bits);
}

}  // namespace

std::uint16_t half_from_float(float value) {
    constexpr float least = 0x1p-14f;
    constexpr float most = 65504.0f;
    if (!(std::abs(value) >= least)) return 0;
    const auto bits = std::bit_cast<std::uint32_t>(std::clamp(value, -most, most));
    const std::uint32_t sign = bits >> 16 & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    const std::uint32_t odd = magnitude >> 13 & 1u;
    const std::uint32_t rounded = (magnitude + 0xfffu + odd) >> 13;
    return static_cast<std::uint16_t>(sign | (rounded - (112u << 10)));
}

TexelImage::TexelImage(int width, int height, std::span<const float> rgba) {
    assert(width >= 1 && height >= 1 && width <= 16384 && height <= 16384);
    assert(rgba.size() ==
           channels * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    add_level(width, height, rgba);
    Texels level{width, height, {}};
    if (width > 1 || height > 1) level.rgba.assign(rgba.begin(), rgba.end());
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        add_level(level.width, level.height, level.rgba);
    }
}

void TexelImage::add_level(int width, int height, std::span<const float> rgba) {
    const auto row = [&](int y) {
        const std::size_t length = channels * static_cast<std::size_t>(width);
        return rgba.subspan(static_cast<std::size_t>(y) * length, length);
    };
    const auto begin = static_cast<std::int32_t>(words_.size() / words_a_texel);
    begins_.push_back(begin + (width + 2 * border) + border);
    widths_.push_back(width);
    heights_.push_back(height);
    add_row(row(height - 1));
    for (int y = 0; y < height; ++y)
        add_row(row(y));
    add_row(row(0));
}

void TexelImage::add_row(std::span<const float> rgba) {
    add_texel(rgba.data() + rgba.size() - channels);
    for (std::size_t i = 0; i < rgba.size(); i += channels)
        add_texel(rgba.data() + i);
    add_texel(rgba.data());
}

void TexelImage::add_texel(const float* rgba) {
    words_.push_back(word_of(rgba[0], rgba[1]));
    words_.push_back(word_of(rgba[2], rgba[3]));
}

}  // namespace scanlight::shading
