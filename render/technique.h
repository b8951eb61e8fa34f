#pragma once

#include <type_traits>

#include "render/flat.h"
#include "render/gouraud.h"
#include "render/phong.h"
#include "render/textured_phong.h"

namespace scanlight::render {

/// Calls `use` with the number as a constant.
template <class Use>
decltype(auto) with_attribute_count(int count, Use&& use) {
    switch (count) {
        case 6:
            return use(std::integral_constant<int, 6>{});
        case 7:
            return use(std::integral_constant<int, 7>{});
        case 9:
            return use(std::integral_constant<int, 9>{});
        default:
            return use(std::integral_constant<int, 3>{});
    }
}

/// Techniques are chosen here, once an object, and nowhere further in. Calls `use` with it.
template <class Use>
decltype(auto) with_technique(const PlacedMesh& placed, const Frame& frame,
                              const Settings& settings, Use&& use) {
    if (settings.shading == Shading::flat) return use(FlatTechnique(placed, frame, settings));
    if (settings.shading == Shading::gouraud) return use(GouraudTechnique(placed, frame, settings));
    if (is_textured(*placed.object, frame)) {
        return with_attribute_count(textured_attributes(*placed.object).count(), [&](auto n) {
            return use(TexturedPhongTechnique<n>(placed, frame, settings));
        });
    }
    return with_model(settings, [&](auto model) {
        return with_paint(*placed.mesh, [&](auto paint) {
            return use(PhongTechnique<decltype(model), paint>(placed, frame, model));
        });
    });
}

}  // namespace scanlight::render
