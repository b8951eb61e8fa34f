#include "shading/reflectance.h"

#include <algorithm>

#include <glm/common.hpp>

namespace scanlight::shading {
namespace {

/// A mirror without loss would have no index.
double in_range(double rho_0) {
    return rho_0 > 0 ? std::min(rho_0, 0.999) : 0.0;
}

double index_of(double rho_0) {
    return index_from_reflectance(in_range(rho_0));
}

}  // namespace

Reflectance dielectric(double n) noexcept {
    return {Reflectance::Kind::dielectric,
            Rgb<double>(n),
            Rgb<double>(0),
            Rgb<double>(fresnel(1.0, n)),
            {}};
}

Reflectance metal(const Rgb<double>& n, const Rgb<double>& k) noexcept {
    const Rgb<double> most(1000.0);
    Reflectance result{Reflectance::Kind::metal, glm::min(n, most), glm::min(k, most), {}, {}};
    result.indices = metal_indices(result.n, result.k);
    result.C_0 = reflectance_at(1.0, result);
    return result;
}

Reflectance metal_of_color(const Rgb<double>& C_0) noexcept {
    return metal({index_of(C_0.x), index_of(C_0.y), index_of(C_0.z)}, Rgb<double>(0));
}

Reflectance shifted(const Reflectance& material) noexcept {
    const Rgb<double>& C_0 = material.C_0;
    const double mean = ((C_0.x + C_0.y) + C_0.z) / 3;
    return {Reflectance::Kind::shifted, Rgb<double>(index_of(mean)), Rgb<double>(0), C_0, {}};
}

}  // namespace scanlight::shading
