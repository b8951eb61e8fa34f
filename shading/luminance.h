#pragma once

#include "shading/vector.h"

namespace scanlight::shading {

/// Of a colour, linear; ITU-R BT.709.
template <class Real>
Real luminance(const Rgb<Real>& c) noexcept {
    return (c.x * Real(0.2126) + c.y * Real(0.7152)) + c.z * Real(0.0722);
}

}  // namespace scanlight::shading
