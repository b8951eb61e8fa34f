#pragma once

#include <span>
#include <string_view>

#include "shading/reflectance.h"

namespace scanlight::shading {

/// A metal as it was measured: its index n + ik at three wavelengths, which stand for red, green
/// and blue.
struct Metal {
    std::string_view name;
    Rgb<double> n;
    Rgb<double> k;
};

/// Copper, gold and silver, from Johnson & Christy 1972, "Optical constants of the noble metals",
/// Physical Review B 6; chromium, iron and titanium from Johnson & Christy 1974, "Optical constants
/// of transition metals: Ti, V, Cr, Mn, Fe, Co, Ni, and Pd", Physical Review B 9: all at 617, 521
/// and 451 nm. Aluminium from Rakić 1995, "Algorithm for the determination of intrinsic optical
/// constants of metal films: application to aluminum", Applied Optics 34, at 620, 517 and 443 nm.
std::span<const Metal> metals() noexcept;

}  // namespace scanlight::shading
