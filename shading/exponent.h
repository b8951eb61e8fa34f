#pragma once

#include <cstdint>

namespace scanlight::shading {

/// The n of (R.V)^n and (N.H)^n, with what `power` needs to know of it, decided once per material
/// rather than once per pixel.
/// Invariant: n = value() lies in [0, 2^24]; least_base() is 2^(-100/n), but at least 2^-126, and 0
/// for n = 0.
class Exponent {
public:
    /// Whole numbers up to this are reached by repeated squaring.
    static constexpr double most_squared = 65536;

    /// Any n, of which a material may well be careless: less than 0 and NaN count as 0, more than
    /// 2^24 as 2^24.
    Exponent(double n) noexcept;  // not explicit: a material is written with a number

    double value() const noexcept { return value_; }
    bool is_whole() const noexcept { return is_whole_; }
    /// value(), if is_whole().
    std::uint32_t whole() const noexcept { return whole_; }
    /// Of anything less than this the power is below 2^-100 and counts as 0, so that no denormal
    /// number, which costs a hundred ordinary ones, arises on the way to it.
    double least_base() const noexcept { return least_base_; }

private:
    double value_;
    bool is_whole_;
    std::uint32_t whole_;
    double least_base_;
};

}  // namespace scanlight::shading
