#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shading/whole.h"

namespace scanlight::shading {

/// An image texture, and smaller and smaller versions of it (Williams 1983, "Pyramidal
/// parametrics", SIGGRAPH). A texel is red, green, blue and alpha, linear; of slopes, two numbers.
/// Invariant: the levels lie one after another, each half as wide and high as the one before,
/// rounded down, but at least 1; the last has one texel. Round each lies a border of one texel, as
/// if the level were repeated: the neighbours of every texel lie beside it.
class TexelImage {
public:
    /// How the numbers of a texel lie in its words.
    enum class Format {
        /// A word a number: as 16-bit integer, a multiple of `unit`, and in the high half that of
        /// the texel on its right, so that the mean of both is one multiplication.
        pairs,
        /// Two numbers a word: 16-bit floats (IEEE 754 half; less than 2^-14 is 0, more than 65504
        /// is 65504).
        halves,
    };
    static constexpr int most_levels = 15;
    static constexpr int border = 1;  // texels, on each side

    /// `rgba`: width x height texels of four numbers, row by row; the first row is at v = 0.
    /// Sides from 1 to 16384. In pairs where all numbers lie from 0 to 1, else in halves.
    TexelImage(int width, int height, std::span<const float> rgba);
    /// Of two numbers a texel, in pairs: not infinite, nor NaN.
    static TexelImage of_slopes(int width, int height, std::span<const float> slopes);

    int width(int level = 0) const noexcept { return widths_[static_cast<std::size_t>(level)]; }
    int height(int level = 0) const noexcept { return heights_[static_cast<std::size_t>(level)]; }
    int levels() const noexcept { return static_cast<int>(begins_.size()); }
    std::size_t bytes() const noexcept { return words_.size() * sizeof(std::int32_t); }
    Format format() const noexcept { return format_; }
    /// Numbers a texel: 4, or 2 of slopes.
    int channels() const noexcept { return channels_; }
    /// Of the integers in pairs: a power of two.
    float unit() const noexcept { return unit_; }

    /// Of a texel of level 0, or of its border: its number in memory.
    std::int32_t index(int x, int y) const noexcept {
        return begins_.front() + y * (width() + 2 * border) + x;
    }

    // By level: its sides, and the number of its first texel.
    const std::int32_t* widths() const noexcept { return widths_.data(); }
    const std::int32_t* heights() const noexcept { return heights_.data(); }
    const std::int32_t* begins() const noexcept { return begins_.data(); }
    /// By texel; as halves, red (low) and green, blue and alpha.
    const std::int32_t* words() const noexcept { return words_.data(); }

private:
    struct Texels {
        int width, height;
        std::vector<float> numbers;
    };

    TexelImage(int channels, Format format, float unit)
        : channels_(channels), format_(format), unit_(unit) {}
    void add_levels(Texels finest);
    void add_level(const Texels& level);
    void add_row(std::span<const float> row);
    void add_texel(const float* texel, const float* next);
    std::int32_t pair_of(float low, float high) const;

    int channels_;
    Format format_;
    float unit_;
    std::vector<std::int32_t> widths_, heights_, begins_;
    std::vector<std::int32_t> words_;
};

/// The 16-bit float nearest to `value`, to even in a tie, within the limits of a `TexelImage`. NaN
/// is 0.
std::uint16_t half_from_float(float value);

/// Of the 16-bit float in the high half of `bits`, exactly. Moved down by three bits it is a
/// float's sign, a small exponent and the mantissa, if copies of the sign are taken out.
template <class Real>
Real real_of_high_half(Whole<Real> bits) noexcept {
    using W = Wholes<Real>;
    constexpr auto float_bits = static_cast<std::int32_t>(0x8fffe000u);
    const Whole<Real> moved = W::divided_by_power(bits, 3);
    return W::real_of_float_bits(moved & Whole<Real>(float_bits)) * Real(0x1p112f);
}

/// The same of the low half.
template <class Real>
Real real_of_half(Whole<Real> bits) noexcept {
    return real_of_high_half<Real>(Wholes<Real>::shifted_left(bits, 16));
}

}  // namespace scanlight::shading
