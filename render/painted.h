#pragma once

#include <type_traits>
#include <utility>

#include <glm/vec3.hpp>

#include "mesh/mesh.h"
#include "shading/material.h"

namespace scanlight::render {

/// Where a surface's own colour comes from.
enum class Paint { material, vertices };

/// A material under a vertex colour, which multiplies what has the body's own colour: ambient and
/// diffuse. The highlights stay, and so does light of its own.
template <class Real>
shading::Material<Real> painted(const shading::Material<float>& material,
                                const shading::Rgb<Real>& color) {
    using shading::Rgb;
    const auto& [diffuse, specular, exponent, eta] = material.transmission;
    return {Rgb<Real>(material.ambient) * color,
            Rgb<Real>(material.diffuse) * color,
            Rgb<Real>(material.specular),
            material.exponent,
            {Rgb<Real>(diffuse) * color, Rgb<Real>(specular), exponent, eta},
            material.facets,
            material.opacity,
            Rgb<Real>(material.mirror),
            Rgb<Real>(material.refracted),
            Rgb<Real>(material.emission),
            material.filter};
}

/// What is lit at a place: the material, painted by `color()` if vertices bring colours.
template <Paint paint, class Color>
decltype(auto) painted_by(const shading::Material<float>& material, Color&& color) {
    if constexpr (paint == Paint::vertices) {
        return painted(material, color());
    } else {
        return (material);
    }
}

/// Calls `use` with the mesh's paint as a constant.
template <class Use>
decltype(auto) with_paint(const mesh::Mesh& mesh, Use&& use) {
    using Vertices = std::integral_constant<Paint, Paint::vertices>;
    using Material = std::integral_constant<Paint, Paint::material>;
    return mesh.vertices.has_colors() ? std::forward<Use>(use)(Vertices{})
                                      : std::forward<Use>(use)(Material{});
}

}  // namespace scanlight::render
