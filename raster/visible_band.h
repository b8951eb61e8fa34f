#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "raster/fixed.h"
#include "raster/rows.h"

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

/// What some rows of the picture show, as one thread sees them: at each pixel the depth of the
/// nearest surface and the record it belongs to. Small enough to stay in the cache of one core.
/// Each row may be read and written `overrun` pixels beyond its end, by whole vectors.
class VisibleBand {
public:
    static constexpr int overrun = 64;

    /// Nothing is seen in `rows` of a picture of this width any more.
    void clear(int width, Rows rows) {
        width_ = width;
        rows_ = rows;
        stride_ = (static_cast<std::size_t>(width) + overrun + 15) / 16 * 16;
        const std::size_t size = stride_ * static_cast<std::size_t>(rows.y_end - rows.y_begin);
        // Depth and item of a pixel must not lie a multiple of 4096 bytes apart: a store to the one
        // would hold up loads of the other.
        items_begin_ = (size + 1023) / 1024 * 1024 + 512;
        memory_.resize(std::max(memory_.size(), items_begin_ + size));
        std::memset(memory_.data(), depth_clear & 0xff, size * sizeof(Depth));
        forget_items();
    }

    /// Forgets whose the pixels are and keeps their depth.
    void forget_items() {
        const std::size_t size = stride_ * static_cast<std::size_t>(rows_.y_end - rows_.y_begin);
        std::memset(memory_.data() + items_begin_, no_item, size * sizeof(Item));
    }

    std::size_t bytes() const { return memory_.capacity() * sizeof(std::int32_t); }
    int width() const { return width_; }
    Rows rows() const { return rows_; }
    /// From a row to the next, in pixels.
    std::size_t stride() const { return stride_; }
    Depth* depth_row(int y) { return memory_.data() + start(y); }
    Item* item_row(int y) { return memory_.data() + items_begin_ + start(y); }
    /// Of all that was drawn into it, over its whole life.
    PixelCounts& counts() { return counts_; }
    const PixelCounts& counts() const { return counts_; }

private:
    std::size_t start(int y) const { return stride_ * static_cast<std::size_t>(y - rows_.y_begin); }

    int width_ = 0;
    Rows rows_{0, 0};
    std::size_t stride_ = 0;
    std::size_t items_begin_ = 0;
    std::vector<std::int32_t> memory_;
    PixelCounts counts_;
};

}  // namespace scanlight::raster
