#pragma once

#include <cassert>
#include <cstdint>

#include "raster/fixed.h"

namespace scanlight::raster {

struct ScreenPoint {
    SubPixel x;
    SubPixel y;
};

/// Where an edge crosses the centre line of the current scanline, kept exactly as the edge is
/// walked down: an integer column and a remainder that carries, as in Bresenham 1965.
///
/// With the edge from (x0, y0) to (x1, y1), dy = y1 - y0 > 0 and the centre line at Y, the crossing
/// in pixel columns, measured from the first column's centre, is N / (256 dy) with
/// N = (x0 - 128) dy + (x1 - x0)(Y - y0). It is kept as column - gap / (256 dy) with
/// 0 <= gap < 256 dy, so that column = ceil(N / (256 dy)). The next line adds 256 dx to N: whole
/// columns, and a remainder that comes off the gap. No error is ever made.
class Crossing {
public:
    Crossing() = default;
    /// From the upper to the lower end, on scanline `row`. Requires top.y < bottom.y.
    [[gnu::always_inline]] Crossing(ScreenPoint top, ScreenPoint bottom, int row)
        : one_((bottom.y - top.y) * subpixels) {
        const SubPixel dy = bottom.y - top.y;
        const SubPixel dx = bottom.x - top.x;
        assert(dy > 0 && "horizontal edges have no crossing");
        const std::int64_t n = std::int64_t{top.x - half_pixel} * dy +
                               std::int64_t{dx} * (row * subpixels + half_pixel - top.y);
        const Quotient above = floor_divided(-n, one_);
        column_ = -above.whole;
        gap_ = above.remainder;
        const Quotient step = floor_divided(dx, dy);
        column_step_ = step.whole;
        gap_step_ = step.remainder * subpixels;
        inverse_ = 1.0 / dy * (1.0 / subpixels);
    }

    void step() {
        gap_ -= gap_step_;
        const std::int32_t borrow = gap_ >> 31;  // -1 or 0: a branch could not be foreseen
        gap_ += one_ & borrow;
        column_ += column_step_ - borrow;
    }

    /// First column whose centre is at or right of the crossing. Used for the left end (included)
    /// and the right end (excluded) alike, it is the top-left rule.
    int column() const { return column_; }

    /// How far the crossing lies left of the centre of `column()`: in pixels, [0, 1).
    double gap() const { return gap_ * inverse_; }

    /// How far it lies right of the centre of the column before: 1 - gap, but computed without loss
    /// when the gap is next to one. In pixels, (0, 1].
    double reach() const { return (one_ - gap_) * inverse_; }

    /// The crossing's x in pixels (a pixel's centre lies at its column + 1/2), and its change from
    /// one scanline to the next: for people to read.
    double x() const { return column_ + 0.5 - gap(); }
    double dx() const { return column_step_ + gap_step_ * inverse_; }

    /// Strict order along the scanline: by crossing, then by the course below it, exactly.
    friend bool left_of(const Crossing& a, const Crossing& b) {
        return a.column_ != b.column_ ? a.column_ < b.column_ : left_of_in_column(a, b);
    }

private:
    static bool left_of_in_column(const Crossing& a, const Crossing& b);

    double inverse_ = 0.0;  // of `one_`
    std::int32_t column_ = 0;
    std::int32_t gap_ = 0;          // in [0, one_)
    std::int32_t one_ = subpixels;  // 256 dy, at most 2^30: the unit of gaps
    std::int32_t column_step_ = 0;
    std::int32_t gap_step_ = 0;  // in [0, one_): what comes off the gap
};

bool left_of(const Crossing& a, const Crossing& b);

}  // namespace scanlight::raster
