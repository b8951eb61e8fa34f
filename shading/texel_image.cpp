#include "shading/texel_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

namespace scanlight::shading {

namespace {

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

/// A level, of so many numbers a texel, made half as wide and high.
class Halving {
public:
    Halving(std::span<const float> from, int width, int height, int channels)
        : from_(from), width_(width), height_(height), channels_(channels) {}

    int width() const { return std::max(1, width_ / 2); }
    int height() const { return std::max(1, height_ / 2); }
    std::vector<float> numbers() const {
        std::vector<float> to;
        for (int y = 0; y < height(); ++y) {
            const Cover rows = cover_of(y, height(), height_);
            for (int x = 0; x < width(); ++x) {
                add_mean(cover_of(x, width(), width_), rows, to);
            }
        }
        return to;
    }

private:
    const float* at(int x, int y) const {
        const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x);
        return from_.data() + texel * static_cast<std::size_t>(channels_);
    }
    /// Over the area that a texel covers.
    void add_mean(const Cover& columns, const Cover& rows, std::vector<float>& to) const {
        double sum[4] = {};
        double area = 0;
        for (int y = rows.begin; y < rows.end; ++y) {
            for (int x = columns.begin; x < columns.end; ++x) {
                const double share = rows.share(y) * columns.share(x);
                area += share;
                for (int c = 0; c < channels_; ++c)
                    sum[c] += share * static_cast<double>(at(x, y)[c]);
            }
        }
        for (int c = 0; c < channels_; ++c)
            to.push_back(static_cast<float>(sum[c] / area));
    }

    std::span<const float> from_;
    int width_, height_, channels_;
};

constexpr float most_in_pair = 32767;

/// The smallest power of two of which no number is more than 32767 times as large.
float unit_of(std::span<const float> numbers) {
    float most = 0x1p-60f;
    for (const float number : numbers)
        most = std::max(most, std::abs(number));
    int exponent = 0;
    std::frexp(most / most_in_pair, &exponent);
    const float unit = std::ldexp(1.0f, exponent - 1);
    return most <= most_in_pair * unit ? unit : 2 * unit;
}

bool are_shares(std::span<const float> numbers) {
    return std::ranges::all_of(numbers, [](float number) { return number >= 0 && number <= 1; });
}

std::int32_t word_of(std::uint16_t low, std::uint16_t high) {
    return static_cast<std::int32_t>(low | static_cast<std::uint32_t>(high) << 16);
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

TexelImage::TexelImage(int width, int height, std::span<const float> rgba)
    : TexelImage(4, are_shares(rgba) ? Format::pairs : Format::halves, unit_of(std::array{1.0f})) {
    add_levels({width, height, {rgba.begin(), rgba.end()}});
}

TexelImage TexelImage::of_slopes(int width, int height, std::span<const float> slopes) {
    TexelImage image(2, Format::pairs, unit_of(slopes));
    image.add_levels({width, height, {slopes.begin(), slopes.end()}});
    return image;
}

void TexelImage::add_levels(Texels level) {
    assert(level.width >= 1 && level.height >= 1 && level.width <= 16384 && level.height <= 16384);
    assert(level.numbers.size() == static_cast<std::size_t>(channels_) *
                                       static_cast<std::size_t>(level.width) *
                                       static_cast<std::size_t>(level.height));
    add_level(level);
    while (level.width > 1 || level.height > 1) {
        const Halving half(level.numbers, level.width, level.height, channels_);
        level = {half.width(), half.height(), half.numbers()};
        add_level(level);
    }
}

void TexelImage::add_level(const Texels& level) {
    const auto row = [&](int y) {
        const auto length =
            static_cast<std::size_t>(channels_) * static_cast<std::size_t>(level.width);
        return std::span(level.numbers).subspan(static_cast<std::size_t>(y) * length, length);
    };
    const int words_a_texel = format_ == Format::pairs ? channels_ : channels_ / 2;
    const auto begin =
        static_cast<std::int32_t>(words_.size() / static_cast<std::size_t>(words_a_texel));
    begins_.push_back(begin + (level.width + 2 * border) + border);
    widths_.push_back(level.width);
    heights_.push_back(level.height);
    add_row(row(level.height - 1));
    for (int y = 0; y < level.height; ++y)
        add_row(row(y));
    add_row(row(0));
}

void TexelImage::add_row(std::span<const float> row) {
    const float* const first = row.data();
    const float* const last = first + row.size() - channels_;
    add_texel(last, first);
    for (const float* texel = first; texel != last; texel += channels_)
        add_texel(texel, texel + channels_);
    add_texel(last, first);
    add_texel(first, row.size() > static_cast<std::size_t>(channels_) ? first + channels_ : first);
}

void TexelImage::add_texel(const float* texel, const float* next) {
    if (format_ == Format::pairs) {
        for (int c = 0; c < channels_; ++c)
            words_.push_back(pair_of(texel[c], next[c]));
    } else {
        for (int c = 0; c < channels_; c += 2)
            words_.push_back(word_of(half_from_float(texel[c]), half_from_float(texel[c + 1])));
    }
}

std::int32_t TexelImage::pair_of(float low, float high) const {
    const auto number = [&](float value) {
        return static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lrint(value / unit_)));
    };
    return word_of(number(low), number(high));
}

}  // namespace scanlight::shading
