#pragma once

#include "shading/power.h"
#include "shading/vector.h"

namespace scanlight::shading {

/// Colours seen through a flat pane, without refraction; Newell, Newell & Sancha 1972, "A solution
/// to the hidden surface problem".
///     I = t I_b + (1 - t) I_a
/// I_a is the pane's own light, I_b what lies behind it, t its transparency: 0 opaque, 1 clear.
/// Several panes are blended from back to front.
template <class Real>
Rgb<Real> blend(const Rgb<Real>& I_a, const Rgb<Real>& I_b, Real t) noexcept {
    return I_b * t + I_a * (Real(1) - t);
}

/// The same from front to back: what is seen of the panes so far, and how much shows through them.
template <class Real>
struct Layers {
    Rgb<Real> light{Real(0)};
    Rgb<Real> transparency{Real(1)};
};

/// One pane more, behind all others; its opacity is 1 - t. Stained glass leaves of each channel no
/// more than `filter`.
template <class Real>
Layers<Real> with_pane_behind(const Layers<Real>& front, const Rgb<Real>& I, Real opacity,
                              const Rgb<Real>& filter = Rgb<Real>(Real(1))) noexcept {
    return {front.light + I * (front.transparency * opacity),
            front.transparency * (filter * (Real(1) - opacity))};
}

/// The picture of panes before a background.
template <class Real>
Rgb<Real> before(const Layers<Real>& front, const Rgb<Real>& background) noexcept {
    return front.light + background * front.transparency;
}

/// The transparency of a curved pane, which is thicker to look through near its outline; Kay &
/// Greenberg 1979, "Transparency for computer synthesized images", SIGGRAPH.
///     t = t_min + (t_max - t_min)(1 - (1 - |N.V|)^p)
template <class Real>
Real curved_transparency(Real t_min, Real t_max, Real NV, const Exponent& p) noexcept {
    const Real facing = select(NV < Real(0), -NV, NV);
    return t_min + (t_max - t_min) * (Real(1) - power(Real(1) - facing, p));
}

}  // namespace scanlight::shading
