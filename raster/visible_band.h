#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "raster/fixed.h"
#include "raster/rows.h"
#include "raster/streams.h"

namespace scanlight::raster {

/// What a pixel shows is told by its polygon's item where its light comes later; this one is no
/// polygon's.
inline constexpr std::int32_t no_item = -1;

inline constexpr Depth behind_everything = 0x7fffffff;

/// How much a pass had to do.
struct PixelCounts {
    std::size_t spans = 0;
    std::size_t tested = 0;
    std::size_t passed = 0;

    PixelCounts& operator+=(const PixelCounts& other) {
        spans += other.spans;
        tested += other.tested;
        passed += other.passed;
        return *this;
    }
    friend PixelCounts operator-(const PixelCounts& a, const PixelCounts& b) {
        return {a.spans - b.spans, a.tested - b.tested, a.passed - b.passed};
    }
};

/// Columns of a picture from `begin` to before `end`.
struct Columns {
    int begin = 0;
    int end = 0;

    [[gnu::always_inline]] void extend(int more_begin, int more_end) {
        begin = std::min(begin, more_begin);
        end = std::max(end, more_end);
    }
};

/// Where a pixel's numbers are: its depth, and `plane` elements further each number that is kept.
struct PixelPlace {
    Depth* depth;
    std::ptrdiff_t plane;

    std::int32_t* kept(int number) const { return depth + plane * (number + 1); }
    PixelPlace operator+(std::ptrdiff_t pixels) const { return {depth + pixels, plane}; }
};

/// What some rows of the picture show, as one thread sees them: at each pixel the depth of the
/// nearest surface, and what is kept of it for its light, a plane a number. Small enough to stay in
/// the cache of one core. Each row may be read and written `overrun` pixels beyond its end, by
/// whole vectors.
class VisibleBand {
public:
    static constexpr int overrun = 64;
    /// Pixels whose depths, say, are in one line of the cache.
    static constexpr int line = LineAllocator<Depth>::line / sizeof(Depth);

    /// Nothing is seen in `rows` of a picture of this width any more. Of what will be seen, so many
    /// numbers will be kept; they are any until then.
    void clear(int width, Rows rows, int kept) {
        const int height = rows.y_end - rows.y_begin;
        if (width != width_ || height > most_rows_ || kept > most_kept_) {
            allocate(width, std::max(height, most_rows_), std::max(kept, most_kept_));
        } else {
            fill_rows(0, seen_, depth_clear & 0xff);
        }
        seen_ = {width, 0};
        rows_ = rows;
        farthest_ = behind_everything;
        passed_before_ = counts_.passed;
    }

    /// No pixel is of any item: the first of the numbers kept.
    void forget_items() {
        fill_rows(1, items_, no_item);
        items_ = {width_, 0};
    }

    // Layers of transparent surfaces, one behind the other, all of them in front of what has been
    // seen so far. The last two numbers kept are the depth and the item of the layer before.

    /// The first layer is to be seen. Two numbers more must be kept than of any surface.
    void begin_layers() {
        const auto size = static_cast<std::size_t>(plane_);
        end_.assign(memory_.begin(), memory_.begin() + static_cast<std::ptrdiff_t>(size));
        std::fill_n(memory_.data() + plane_ * (layer_before() + 1), 2 * size, -1);
        restart_layer();
    }
    /// The next one is.
    void next_layer() {
        std::copy_n(memory_.data(), plane_, memory_.data() + plane_ * (layer_before() + 1));
        std::copy_n(memory_.data() + plane_, plane_,
                    memory_.data() + plane_ * (layer_before() + 2));
        std::ranges::copy(end_, memory_.begin());
        restart_layer();
    }
    /// The first of the two numbers.
    int layer_before() const { return most_kept_ - 2; }

    std::size_t bytes() const { return bytes_held(memory_, end_); }
    int width() const { return width_; }
    Rows rows() const { return rows_; }
    /// From a row to the next, in pixels.
    std::ptrdiff_t stride() const { return stride_; }

    /// The row's first pixel.
    PixelPlace row(int y) { return {memory_.data() + stride_ * (y - rows_.y_begin), plane_}; }
    Depth* depth_row(int y) { return row(y).depth; }
    std::int32_t* kept_row(int number, int y) { return row(y).kept(number); }

    /// Whoever draws says where.
    [[gnu::always_inline]] void touch(int x_begin, int x_end) {
        seen_.extend(x_begin, x_end);
        items_.extend(x_begin, x_end);
    }
    /// Nothing is seen in other columns. They begin with a line of the cache, up to 15 columns
    /// before the first that was touched.
    Columns touched() const { return {seen_.begin / line * line, seen_.end}; }

    /// Nothing that is seen lies farther. Depths only come nearer: once found, this holds on.
    Depth farthest() const { return farthest_; }
    /// Whether it may have come nearer since it was found.
    bool farthest_may_change() const { return counts_.passed != passed_before_; }
    void set_farthest(Depth depth) {
        farthest_ = depth;
        passed_before_ = counts_.passed;
    }
    std::size_t pixels() const {
        return static_cast<std::size_t>(width_) *
               static_cast<std::size_t>(rows_.y_end - rows_.y_begin);
    }

    /// Of all that was drawn into it, over its whole life.
    PixelCounts& counts() { return counts_; }
    const PixelCounts& counts() const { return counts_; }

private:
    void restart_layer() {
        forget_items();
        farthest_ = behind_everything;
        passed_before_ = counts_.passed;
    }

    void allocate(int width, int height, int kept) {
        width_ = width;
        most_rows_ = height;
        most_kept_ = kept;
        stride_ = (width + overrun + line - 1) / line * line;
        // A pixel's numbers must not lie multiples of 4096 bytes apart: a store to the one would
        // hold up loads of the other. Planes begin with a line too.
        plane_ = (stride_ * height + 1023) / 1024 * 1024 + 160;
        memory_.assign(static_cast<std::size_t>(plane_ * (kept + 1)), no_item);
        std::fill_n(memory_.begin(), plane_, depth_clear);
        items_ = {width, 0};
    }

    /// Columns of one plane, in all rows there is memory for.
    void fill_rows(int plane, Columns columns, int byte) {
        if (columns.begin >= columns.end) return;
        const auto count = static_cast<std::size_t>(columns.end - columns.begin);
        for (int row = 0; row < most_rows_; ++row) {
            std::memset(memory_.data() + plane * plane_ + row * stride_ + columns.begin, byte,
                        count * sizeof(std::int32_t));
        }
    }

    int width_ = 0;
    Rows rows_{0, 0};
    int most_rows_ = 0;  // that there is memory for
    int most_kept_ = 0;
    Columns seen_;   // where depth may be other than clear
    Columns items_;  // where items may be
    std::ptrdiff_t stride_ = 0;
    std::ptrdiff_t plane_ = 0;
    LineVector<std::int32_t> memory_;
    std::vector<Depth> end_;  // the depths in front of which all layers lie
    PixelCounts counts_;
    Depth farthest_ = behind_everything;
    std::size_t passed_before_ = 0;  // before it was found
};

}  // namespace scanlight::raster
