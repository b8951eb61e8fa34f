#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "raster/framebuffer.h"
#include "render/draw.h"
#include "shading/blending.h"

namespace scanlight::render {

// Transparent surfaces, by colour blending (Newell, Newell & Sancha 1972, "A solution to the hidden
// surface problem", ACM National Conference):
//     I = t I_b + (1 - t) I_a
// of the surface in front, a, and all that is behind it, b. No refraction. At each pixel the
// surfaces are taken in the order of their depths, the nearest first, one layer of all pixels after
// another (depth peeling: Mammen 1989, "Transparency and antialiasing algorithms implemented with
// the virtual pixel maps technique", IEEE CG&A 9(4); Everitt 2001). So the order of the input does
// not matter, and polygons that intersect come out right.

/// The layers of a pixel so far.
class Blend {
public:
    /// A layer behind those so far.
    void add(const glm::vec3& light, float opacity, const glm::vec3& filter) {
        layers_ = shading::with_pane_behind(layers_, light, opacity, filter);
    }

    /// No layer, or none that can be seen.
    bool is_clear() const {
        return layers_.transparency == glm::vec3(1.0f) && layers_.light == glm::vec3(0.0f);
    }

    /// With what lies behind them all. Alpha, of which there is one for all channels, goes by the
    /// channel that lets most through; it is never premultiplied.
    raster::Rgba over(const raster::Rgba& behind) const {
        const auto& [light, transparency] = layers_;
        const float most = std::max({transparency.r, transparency.g, transparency.b});
        const float alpha = 1.0f - most * (1.0f - behind.a);
        if (alpha <= 0.0f) return raster::Rgba(0.0f);
        return raster::Rgba((light + glm::vec3(behind) * (transparency * behind.a)) / alpha, alpha);
    }

private:
    shading::Layers<float> layers_;
};

/// More layers than this are not drawn at a pixel.
inline constexpr int most_layers = 1024;

/// Draws a scene with transparent objects: the opaque ones first. Transparent ones are in shadow
/// but cast none.
Drawing draw_with_layers(const Scene& scene, const Settings& settings, raster::Viewport viewport);

}  // namespace scanlight::render
