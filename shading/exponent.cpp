#include "shading/exponent.h"

#include <algorithm>

#include "shading/base2.h"

namespace scanlight::shading {
namespace {

double in_range(double n) {
    return n > 0 ? std::min(n, 0x1p24) : 0.0;  // NaN is not > 0
}

bool is_squared(double n) {
    return n <= Exponent::most_squared && n == static_cast<double>(static_cast<std::uint32_t>(n));
}

double least_base_of(double n) {
    return n > 0 ? exp2_of(std::max(-100 / n, -126.0)) : 0.0;
}

}  // namespace

Exponent::Exponent(double n) noexcept
    : value_(in_range(n)),
      is_whole_(is_squared(value_)),
      whole_(is_whole_ ? static_cast<std::uint32_t>(value_) : 0),
      least_base_(least_base_of(value_)) {}

}  // namespace scanlight::shading
