#include "raster/crossing.h"

namespace scanlight::raster {

bool Crossing::left_of_in_column(const Crossing& a, const Crossing& b) {
    const std::int64_t gap_a = std::int64_t{a.gap_} * b.one_;  // below 2^60
    const std::int64_t gap_b = std::int64_t{b.gap_} * a.one_;
    if (gap_a != gap_b) return gap_a > gap_b;
    if (a.column_step_ != b.column_step_) return a.column_step_ < b.column_step_;
    return std::int64_t{a.gap_step_} * b.one_ < std::int64_t{b.gap_step_} * a.one_;
}

}  // namespace scanlight::raster
