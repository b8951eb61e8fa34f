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

/// The number of a record: of what a pixel shows, see `AttributeRecords`.
using Item = std::int32_t;
inline constexpr Item no_item = -1;

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
};

/// Columns of a picture from `begin` to before `end`.
struct Columns {
    int begin = 0;
    int end = 0;
};

/// What some rows of the picture show, as one thread sees them: at each pixel the depth of the
/// nearest surface and the record it belongs to. Small enough to stay in the cache of one core.
/// Each row may be read and written `overrun` pixels beyond its end, by whole vectors.
/// Invariant: memory says that nothing is seen anywhere but in the touched columns of `rows()`.
class VisibleBand {
public:
    static constexpr int overrun = 64;

    /// Nothing is seen in `rows` of a picture of this width any more.
    void clear(int width, Rows rows) {
        const int height = rows.y_end - rows.y_begin;
        if (width != width_ || height > most_rows_) {
            allocate(width, height);
        } else {
            fill_rows(0, depth_clear & 0xff);
            forget_items();
        }
        touched_ = {width, 0};
        rows_ = rows;
    }

    /// Forgets whose the pixels are and keeps their depth.
    void forget_items() { fill_rows(items_begin_, no_item); }

    std::size_t bytes() const { return bytes_held(memory_); }
    int width() const { return width_; }
    Rows rows() const { return rows_; }
    /// From a row to the next, in pixels.
    std::size_t stride() const { return stride_; }
    Depth* depth_row(int y) { return memory_.data() + start(y); }
    Item* item_row(int y) { return memory_.data() + items_begin_ + start(y); }

    /// Whoever draws says where.
    void touch(int x_begin, int x_end) {
        touched_ = {std::min(touched_.begin, x_begin), std::max(touched_.end, x_end)};
    }
    Columns touched() const { return touched_; }

    /// Of all that was drawn into it, over its whole life.
    PixelCounts& counts() { return counts_; }
    const PixelCounts& counts() const { return counts_; }

private:
    void allocate(int width, int height) {
        width_ = width;
        stride_ = (static_cast<std::size_t>(width) + overrun + 15) / 16 * 16;
        const std::size_t size = stride_ * static_cast<std::size_t>(height);
        // Depth and item of a pixel must not lie a multiple of 4096 bytes apart: a store to the one
        // would hold up loads of the other.
        items_begin_ = (size + 1023) / 1024 * 1024 + 512;
        memory_.assign(items_begin_, depth_clear);
        memory_.resize(items_begin_ + size, no_item);
        most_rows_ = height;
    }

    /// The touched columns of all rows, from a place in memory on.
    void fill_rows(std::size_t begin, int byte) {
        if (touched_.begin >= touched_.end) return;
        const auto columns = static_cast<std::size_t>(touched_.end - touched_.begin);
        for (int row = 0; row < rows_.y_end - rows_.y_begin; ++row) {
            std::int32_t* const to =
                memory_.data() + begin + stride_ * static_cast<std::size_t>(row) + touched_.begin;
            std::memset(to, byte, columns * sizeof(std::int32_t));
        }
    }

    std::size_t start(int y) const { return stride_ * static_cast<std::size_t>(y - rows_.y_begin); }

    int width_ = 0;
    Rows rows_{0, 0};
    int most_rows_ = 0;  // that there is memory for
    Columns touched_;
    std::size_t stride_ = 0;
    std::size_t items_begin_ = 0;
    std::vector<std::int32_t> memory_;
    PixelCounts counts_;
};

}  // namespace scanlight::raster
