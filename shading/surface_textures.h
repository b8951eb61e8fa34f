#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "shading/environment.h"
#include "shading/texture.h"

namespace scanlight::shading {

/// What the textures of a material change. A colour multiplies the material's own.
struct SurfaceTextures {
    std::optional<Texture> ambient;  // if there is none, `diffuse` colours ambient light too
    std::optional<Texture> diffuse;
    std::optional<Texture> specular;
    std::optional<Texture> exponent;  // its number multiplies n
    std::optional<Texture> opacity;   // its number multiplies the opacity
    std::optional<Texture> emission;
    std::optional<Texture> bump;    // its luminance, a height, moves the normal; see `slopes_of`
    std::optional<Texture> normal;  // a normal map: 0 to 1 stands for -1 to 1
    std::shared_ptr<const Environment> mirrored;  // by K_s' and K_t', in place of the scene's
    float bump_height = 1;                        // of luminance 1, world units
    float normal_scale = 1;                       // of x and y of the normal map

    /// Whether there is a texture that `is` so.
    template <class Is>
    bool any_that(Is&& is) const {
        const auto there = [&](const std::optional<Texture>& t) {
            return t && std::invoke(is, *t);
        };
        return there(ambient) || there(diffuse) || there(specular) || there(exponent) ||
               there(opacity) || there(emission) || there(bump) || there(normal);
    }
    bool any() const {
        return mirrored || any_that([](const Texture&) { return true; });
    }
    bool needs_uv() const { return any_that(&Texture::needs_uv); }
    SiteNeeds needs() const {
        SiteNeeds needs;
        any_that([&](const Texture& t) {
            add(t, needs);
            return false;
        });
        needs.gradients = (bump && bump->needs_uv()) || (normal && normal->needs_uv());
        return needs;
    }

private:
    static void add(const Texture& t, SiteNeeds& to) {
        const bool has_uv = t.needs_uv();
        to.point |= !has_uv;
        to.uv_steps |= t.is_filtered() && has_uv;
        to.steps |= t.is_filtered() && !has_uv;
        if (t.is_filtered() && has_uv) to.texels = glm::max(to.texels, t.texels());
    }
};

}  // namespace scanlight::shading
