#pragma once

#include <algorithm>
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

    static constexpr bool works_on_few = true;

    /// See `illuminate_few`.
    template <class SomePlaces, class LightAt, class Take>
    void at_few(const SomePlaces& places, const LightAt& light_at, Take&& take) const noexcept {
        const auto angles = few_of(places.count, [&](int i) {
            const auto& [point, N, V] = places.surface_at(i);
            return phong_angles(N, light_at(i).direction, V);
        });
        const auto highlights = few_of(angles.count(), [&](int i) {
            return phong(angles[i], places.material_at(i).exponent);
        });
        for (int i = 0; i < places.count; ++i) {
            const auto& material = places.material_at(i);
            const Rgb<typename SomePlaces::Real> K_d(material.diffuse);
            const Rgb<typename SomePlaces::Real> K_s(material.specular);
            take(i,
                 light_at(i).intensity * (K_d * positive_part(angles[i].LN) + K_s * highlights[i]));
        }
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

    /// See `illuminate_few`.
    template <class SomePlaces, class LightAt, class Take>
    void at_few(const SomePlaces& places, const LightAt& light_at, Take&& take) const noexcept {
        const auto angles = few_of(places.count, [&](int i) {
            const auto& [point, N, V] = places.surface_at(i);
            return facet_angles(N, light_at(i).direction, V);
        });
        const auto shares = few_of(angles.count(), [&](int i) {
            return facets_share(angles[i], places.material_at(i).facets.slopes);
        });
        const auto cosine_at = [&](int i) { return angles[i].VH(); };
        const auto add_body = [&](int i, const auto& rho) {
            take(i, together(places.surface_at(i), places.material_at(i), light_at(i),
                             rho * shares[i]));
        };
        const auto& material = places.material_at(0);
        reflectances_at(angles.count(), cosine_at, material.facets.reflectance, add_body);
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

/// Whether any light depends on where it falls.
template <class Number>
bool has_lamp(const Lighting<Number>& lighting) noexcept {
    const auto is_lamp = [](const Light<Number>& light) {
        return light.kind == Light<Number>::Kind::point;
    };
    return std::ranges::any_of(lighting.lights, is_lamp);
}

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

/// A few surfaces, at least one, that are to be lit: `surface_at(i)` and `material_at(i)`, as often
/// as they are asked for. All of one material, but for its colours and its exponent.
template <class Number, class SurfaceAt, class MaterialAt>
struct Places {
    using Real = Number;

    int count;
    SurfaceAt surface_at;
    MaterialAt material_at;
};

template <class Real, class SurfaceAt, class MaterialAt>
Places<Real, SurfaceAt, MaterialAt> places_of(int count, const SurfaceAt& surface_at,
                                              const MaterialAt& material_at) noexcept {
    return {count, surface_at, material_at};
}

/// `illuminate`, of a few surfaces, each step of the way for all of them. Calls `take(i, color)`
/// for each; `arriving(i, light, term)`.
template <WorksOnFew Model, class SomePlaces, class LightNumber, class Arriving, class Take>
void illuminate_few(const Model& model, const SomePlaces& places,
                    const Lighting<LightNumber>& lighting, const Arriving& arriving,
                    Take&& take) noexcept {
    using Real = typename SomePlaces::Real;
    auto intensities =
        few_of(places.count, [&](int i) { return unlit<Real>(places.material_at(i), lighting); });
    for (std::size_t k = 0; k < lighting.lights.size(); ++k) {
        const Light<LightNumber>& light = lighting.lights[k];
        const auto add = [&](int i, const Rgb<Real>& term) {
            intensities[i] = intensities[i] + arriving(i, k, term);
        };
        if (light.kind == Light<LightNumber>::Kind::directional) {
            const auto incident = [&](int) { return incident_from_infinity<Real>(light); };
            model.at_few(places, incident, add);
        } else {
            const auto incidents = few_of(places.count, [&](int i) {
                return incident_from_lamp(light, places.surface_at(i).point);
            });
            model.at_few(
                places, [&](int i) -> const auto& { return incidents[i]; }, add);
        }
    }
    for (int i = 0; i < places.count; ++i)
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
