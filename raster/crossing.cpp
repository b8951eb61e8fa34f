#include "raster/crossing.h"

#include <cassert>

namespace scanlight::raster {

Crossing::Crossing(ScreenPoint top, ScreenPoint bottom, int row)
    : height_(bottom.y - top.y), shortfall_(0) {
    assert(height_ > 0 && "horizontal edges have no crossing");
    const std::int64_t dx = bottom.x - top.x;
    const std::int64_t line = std::int64_t{row} * subpixels + half_pixel;
    const std::int64_t n = std::int64_t{top.x - half_pixel} * height_ + dx * (line - top.y);
    const std::int64_t n_whole = ceil_div(n, subpixels);
    const std::int64_t t = n_whole + height_ - 1;
    column_ = static_cast<std::int32_t>(floor_div(t, height_));
    remainder_ = static_cast<std::int32_t>(t - std::int64_t{column_} * height_);
    whole_step_ = static_cast<std::int32_t>(floor_div(dx, height_));
    fraction_step_ = static_cast<std::int32_t>(dx - std::int64_t{whole_step_} * height_);
    shortfall_ = static_cast<std::int32_t>(n_whole * subpixels - n);
}

bool left_of(const Crossing& a, const Crossing& b) {
    if (a.column_ != b.column_) return a.column_ < b.column_;
    const std::int64_t gap_a = a.gap_numerator() * b.height_;  // below 2^30 * 2^22
    const std::int64_t gap_b = b.gap_numerator() * a.height_;
    if (gap_a != gap_b) return gap_a > gap_b;
    if (a.whole_step_ != b.whole_step_) return a.whole_step_ < b.whole_step_;
    return std::int64_t{a.fraction_step_} * b.height_ < std::int64_t{b.fraction_step_} * a.height_;
}

}  // namespace scanlight::raster
