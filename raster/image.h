#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace scanlight::raster {

/// A picture in memory: row-major, top row first, the channels of a pixel side by side: 1 is grey,
/// 2 grey and alpha, 3 red green blue, 4 RGB and alpha (never premultiplied).
/// Invariant: there are width · height · channels samples.
template <class Sample>
class Image {
public:
    /// No pixels at all.
    Image() = default;

    /// All samples zero. `width` and `height` from 0, `channels` 1 to 4.
    Image(int width, int height, int channels)
        : width_(width),
          height_(height),
          channels_(channels),
          samples_(sample_count(width, height, channels)) {}

    int width() const noexcept { return width_; }
    int height() const noexcept { return height_; }
    int channels() const noexcept { return channels_; }

    /// The channels of pixel column `x`, row `y`; the first row is the top one.
    std::span<Sample> pixel(int x, int y) { return span_at(samples_, x, y, 1); }
    std::span<const Sample> pixel(int x, int y) const { return span_at(samples_, x, y, 1); }

    std::span<Sample> row(int y) { return span_at(samples_, 0, y, width_); }
    std::span<const Sample> row(int y) const { return span_at(samples_, 0, y, width_); }

    std::span<Sample> samples() noexcept { return samples_; }
    std::span<const Sample> samples() const noexcept { return samples_; }

    bool operator==(const Image&) const = default;

private:
    static std::size_t sample_count(int width, int height, int channels) {
        assert(width >= 0 && height >= 0 && channels >= 1 && channels <= 4);
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(channels);
    }

    template <class Samples>
    auto span_at(Samples& samples, int x, int y, int pixels) const {
        assert(x >= 0 && x + pixels <= width_ && y >= 0 && y < height_);
        const auto stride = static_cast<std::size_t>(channels_);
        const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x);
        return std::span(samples).subspan(first * stride,
                                          static_cast<std::size_t>(pixels) * stride);
    }

    int width_ = 0;
    int height_ = 0;
    int channels_ = 1;
    std::vector<Sample> samples_;
};

using Image8 = Image<std::uint8_t>;    // colour is sRGB-encoded
using Image16 = Image<std::uint16_t>;  // depth and other measured values, 0 to 65535
using ImageF = Image<float>;           // linear, unclamped

/// Whatever an image file may hold.
using AnyImage = std::variant<Image8, Image16, ImageF>;

}  // namespace scanlight::raster
