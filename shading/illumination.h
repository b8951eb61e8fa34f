#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "shading/ambient.h"
#include "shading/blinn.h"
#include "shading/cook_torrance.h"
#include "shading/few.h"
#include "shading/gouraud_1971.h"
#include "shading/lambert.h"
#include "shading/light.h"
#include "shading/material.h"
#include "shading/phong.h"
#include "shading/surface.h"
#include "shading/transmission.h"

namespace scanlight::shading {

// The simple illumination models, in colour:
//     I = I_e + I_a K_a + sum over the lights of I_p [K_d diffuse + K_s highlight]
// where I_e is the surface's own light.
// A model is a function object that gives one light's part of the sum, so that the compiler builds
// each model's loop of its own and none asks per pixel which it is. A new model is a new struct
// here and a new case in `with_illumination`.

/// Diffuse light only.
struct Lambert {
    template <class Real, class Number, class Power>
    Rgb<Real> operator()(const Surface<Real>& surface, const Material<Number, Power>& material,
                         const Incident<Real>& light) const noexcept {
        const Rgb<Real> K_d(material.diffuse);
        return light.intensity * (K_d * lambert(surface.normal, light.direction));
    }
};

/// Diffuse light and a highlight around the mirrored light, (R.V)^n.
struct Phong {
    template <class Real, class Number, class Power>
    Rgb<Real> operator()(const Surface<Real>& surface, const Material<Number, Power>& material,
                         const Incident<Real>& light) const noexcept {
        const auto& [point, N, V] = surface;
        const Vec3<Real>& L = light.direction;
        const Rgb<Real> K_d(material.diffuse);
        const Rgb<Real> K_s(material.specular);
        return light.intensity * (K_d * lambert(N, L) + K_s * phong(N, L, V, material.exponent));
    }
};

/// Diffuse light and a highlight around the half vector, (N.H)^n.
struct Blinn {
    template <class Real, class Number, class Power>
    Rgb<Real> operator()(const Surface<Real>& surface, const Material<Number, Power>& material,
                         const Incident<Real>& light) const noexcept {
        const auto& [point, N, V] = surface;
        const Vec3<Real>& L = light.direction;
        const Vec3<Real> H = half_vector(L, V);
        const Rgb<Real> K_d(material.diffuse);
        const Rgb<Real> K_s(material.specular);
        return light.intensity * (K_d * lambert(N, L) + K_s * blinn(N, L, H, material.exponent));
    }
};

/// Diffuse light divided by r + k. The division is the model's own fall-off: lights are meant to
/// keep Falloff::constant, or both take effect.
struct Gouraud1971 {
    float k = 1;  // world units

    template <class Real, class Number, class Power>
    Rgb<Real> operator()(const Surface<Real>& surface, const Material<Number, Power>& material,
                         const Incident<Real>& light) const noexcept {
        const Rgb<Real> K_d(material.diffuse);
        return light.intensity *
               (K_d * gouraud_1971(surface.normal, light.direction, light.distance, Real(k)));
    }
};

/// Blinn's light before the surface, and what comes through it of the light behind; Hall &
/// Greenberg 1983. The local part of Whitted's model, which is Blinn's, knows only the former.
///     I_p [K_d (N.L)+ + K_s ((N.H)+)^n + K_dt (-N.L)+ + K_t ((N.H_t)+)^n_t]
struct Hall {
    template <class Real, class Number, class Power>
    Rgb<Real> operator()(const Surface<Real>& surface, const Material<Number, Power>& material,
                         const Incident<Real>& light) const noexcept {
        const auto& [point, N, V] = surface;
        const Vec3<Real>& L = light.direction;
        const auto& [diffuse, specular, n_t, eta] = material.transmission;
        const Rgb<Real> K_dt(diffuse);
        const Rgb<Real> K_t(specular);
        const Rgb<Real> through =
            K_dt * transmitted_diffuse(N, L) + K_t * transmitted_highlight(N, L, V, eta, n_t);
        return Blinn{}(surface, material, light) + light.intensity * through;
    }
};

/// Diffuse light and what microfacets mirror; Cook & Torrance 1981.
///     E (N.L)+ (K_d R_d + K_s R_s), R_d = rho_d/pi, K_d + K_s = 1
/// For a lamp's irradiance E, in the paper I_i d_omega, stands pi I_p: then K_d rho_d plays the
/// part of Phong's K_d, and the diffuse halves agree.
struct CookTorrance {
    template <class Real, class Number, class Power>
    Rgb<Real> operator()(const Surface<Real>& surface, const Material<Number, Power>& material,
                         const Incident<Real>& light) const noexcept {
        const Microfacets& facets = material.facets;
        return together(surface, material, light,
                        cook_torrance(surface.normal, light.direction, surface.view, facets.slopes,
                                      facets.reflectance));
    }

    static constexpr bool works_on_few = true;

    /// Calls `take(i, term)` for each of a few surfaces, with the light that falls on each.
    template <class Real, class Number, class Power, class Take>
    void at_few(const Few<const Surface<Real>*>& surfaces, const Material<Number, Power>& material,
                const Few<Incident<Real>>& lights, Take&& take) const noexcept {
        const Microfacets& facets = material.facets;
        const auto angles = few_of(surfaces.count(), [&](int i) {
            return facet_angles(surfaces[i]->normal, lights[i].direction, surfaces[i]->view);
        });
        const auto shares =
            few_of(angles.count(), [&](int i) { return facets_share(angles[i], facets.slopes); });
        for (int i = 0; i < surfaces.count(); ++i) {
            const Rgb<Real> mirrored = reflectance_at(angles[i].VH, facets.reflectance) * shares[i];
            take(i, together(*surfaces[i], material, lights[i], mirrored));
        }
    }

private:
    template <class Real, class Number, class Power>
    static Rgb<Real> together(const Surface<Real>& surface, const Material<Number, Power>& material,
                              const Incident<Real>& light, const Rgb<Real>& mirrored) noexcept {
        const Rgb<Real> rho_d(material.diffuse);
        const Rgb<Real> body =
            rho_d * (Real(1 - material.facets.share) * lambert(surface.normal, light.direction));
        return light.intensity * (body + mirrored * Real(pi * material.facets.share));
    }
};

/// All the light of a scene.
template <class Number>
struct Lighting {
    Rgb<Number> ambient{Number(0)};  // I_a
    std::vector<Light<Number>> lights;
};

/// What a surface sends without any light source: its own light, and the ambient term.
template <class Real, class Number, class Power, class LightNumber>
Rgb<Real> unlit(const Material<Number, Power>& material,
                const Lighting<LightNumber>& lighting) noexcept {
    return Rgb<Real>(material.emission) +
           ambient(Rgb<Real>(lighting.ambient), Rgb<Real>(material.ambient));
}

/// The light that `surface` sends to its viewer: `intensity`, then each light in the order of the
/// list, added one by one, for the bits depend on it. World space; linear, not clamped, never
/// negative or NaN as long as material and lights are neither and all is finite.
/// `arriving(i, term)` is what is left of the i-th light's term: nothing where the light is hidden.
template <class Model, class Real, class Number, class Power, class LightNumber, class Arriving>
Rgb<Real> with_lights(Rgb<Real> intensity, const Model& model, const Surface<Real>& surface,
                      const Material<Number, Power>& material,
                      const Lighting<LightNumber>& lighting, const Arriving& arriving) noexcept {
    for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
        const Light<LightNumber>& light = lighting.lights[i];
        intensity =
            intensity + arriving(i, model(surface, material, incident_at(light, surface.point)));
    }
    return intensity;
}

/// The light that `surface` sends to its viewer: its own, the ambient term, and all lights.
template <class Model, class Real, class Number, class Power, class LightNumber, class Arriving>
Rgb<Real> illuminate(const Model& model, const Surface<Real>& surface,
                     const Material<Number, Power>& material, const Lighting<LightNumber>& lighting,
                     const Arriving& arriving) noexcept {
    return with_lights(unlit<Real>(material, lighting), model, surface, material, lighting,
                       arriving);
}

/// A model that takes each step of its way for a few surfaces together.
template <class Model>
concept WorksOnFew = requires {
    requires Model::works_on_few;
};

/// `illuminate`, of a few surfaces of one material. Calls `take(i, color)` for each; `arriving(i,
/// light, term)`.
template <WorksOnFew Model, class Real, class Number, class Power, class LightNumber,
          class Arriving, class Take>
void illuminate_few(const Model& model, const Few<const Surface<Real>*>& surfaces,
                    const Material<Number, Power>& material, const Lighting<LightNumber>& lighting,
                    const Arriving& arriving, Take&& take) noexcept {
    auto intensities =
        few_of(surfaces.count(), [&](int) { return unlit<Real>(material, lighting); });
    for (std::size_t k = 0; k < lighting.lights.size(); ++k) {
        const auto incidents = few_of(surfaces.count(), [&](int i) {
            return incident_at(lighting.lights[k], surfaces[i]->point);
        });
        model.at_few(surfaces, material, incidents, [&](int i, const Rgb<Real>& term) {
            intensities[i] = intensities[i] + arriving(i, k, term);
        });
    }
    for (int i = 0; i < surfaces.count(); ++i)
        take(i, intensities[i]);
}

/// The same where nothing casts a shadow.
template <class Model, class Real, class Number, class LightNumber = Number>
Rgb<Real> illuminate(const Model& model, const Surface<Real>& surface,
                     const Material<Number>& material,
                     const Lighting<LightNumber>& lighting) noexcept {
    const auto all = [](std::size_t, const Rgb<Real>& term) { return term; };
    return illuminate(model, surface, material, lighting, all);
}

/// The same for a model with its usual constants: `illuminate<Phong>(…)`.
template <class Model, class Real, class Number>
Rgb<Real> illuminate(const Surface<Real>& surface, const Material<Number>& material,
                     const Lighting<Number>& lighting) noexcept {
    return illuminate(Model{}, surface, material, lighting);
}

/// Which model, where it is chosen while the program runs.
enum class Illumination { lambert, gouraud71, phong, blinn, hall, cook_torrance };

/// Calls `use` with the model's function object and returns what it returns. This stands outside
/// the loop over pixels:
///     with_illumination(kind, [&](auto model) { for (…) … illuminate(model, …); });
/// A model with a constant of its own is an argument.
template <class Use>
decltype(auto) with_illumination(Illumination kind, Use&& use, Gouraud1971 gouraud71 = {}) {
    switch (kind) {
        case Illumination::gouraud71:
            return std::forward<Use>(use)(gouraud71);
        case Illumination::phong:
            return std::forward<Use>(use)(Phong{});
        case Illumination::blinn:
            return std::forward<Use>(use)(Blinn{});
        case Illumination::hall:
            return std::forward<Use>(use)(Hall{});
        case Illumination::cook_torrance:
            return std::forward<Use>(use)(CookTorrance{});
        case Illumination::lambert:
            break;
    }
    return std::forward<Use>(use)(Lambert{});
}

}  // namespace scanlight::shading
