#pragma once

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
/// N = (x0 - 128) dy + (x1 - x0)(Y - y0). The next line adds 256 dx to N, so ceil(N / 256) grows by
/// exactly dx, and since ceil(N / (256 dy)) = ceil(ceil(N / 256) / dy) so does the column's
/// numerator: no error is ever made.
class Crossing {
public:
    Crossing() = default;
    /// From the upper to the lower end, on scanline `row`. Requires top.y < bottom.y.
    Crossing(ScreenPoint top, ScreenPoint bottom, int row);

    void step() {
        column_ += whole_step_;
        remainder_ += fraction_step_;
        const int carry = remainder_ >= height_ ? 1 : 0;
        column_ += carry;
        remainder_ -= carry ? height_ : 0;
    }

    /// First column whose centre is at or right of the crossing. Used for the left end (included)
    /// and the right end (excluded) alike, it is the top-left rule.
    int column() const { return column_; }

    /// How far the crossing lies left of the centre of `column()`: in pixels, [0, 1).
    double gap() const {
        return static_cast<double>(gap_numerator()) / (double{subpixels} * height_);
    }

    /// How far it lies right of the centre of the column before: 1 - gap, but computed without loss
    /// when the gap is next to one. In pixels, (0, 1].
    double reach() const {
        const std::int64_t whole = std::int64_t{height_} * subpixels;
        return static_cast<double>(whole - gap_numerator()) / static_cast<double>(whole);
    }

    /// The crossing's x in pixels (a pixel's centre lies at its column + 1/2), and its change from
    /// one scanline to the next: for people to read.
    double x() const { return column_ + 0.5 - gap(); }
    double dx() const { return whole_step_ + static_cast<double>(fraction_step_) / height_; }

    /// Strict order along the scanline: by crossing, then by the course below it, exactly.
    friend bool left_of(const Crossing& a, const Crossing& b);

private:
    std::int64_t gap_numerator() const {  // over 256 * height_
        return std::int64_t{height_ - 1 - remainder_} * subpixels + shortfall_;
    }

    std::int32_t column_ = 0;
    std::int32_t remainder_ = 0;  // of the column's ceiling, in [0, height_)
    std::int32_t height_ = 1;     // dy
    std::int32_t whole_step_ = 0;
    std::int32_t fraction_step_ = 0;  // in [0, height_)
    std::int32_t shortfall_ = 0;      // 256 ceil(N / 256) - N: the same on every scanline
};

bool left_of(const Crossing& a, const Crossing& b);

}  // namespace scanlight::raster
