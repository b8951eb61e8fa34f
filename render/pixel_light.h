#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "raster/framebuffer.h"
#include "render/scene.h"

namespace scanlight::render {

/// What a texture says at a pixel.
struct TextureAtPixel {
    const char* slot;             // "diffuse", "bump" and so on
    std::optional<glm::vec2> uv;  // its place on the texture; none of one that fills space
    glm::vec3 color;              // linear
};

/// The terms of Cook and Torrance at a pixel.
struct FacetTerms {
    float D, G;
    glm::vec3 F;
};

/// What one light adds to the intensity at a pixel, and what it is reckoned from. World space.
struct LightAtPixel {
    glm::vec3 L;           // unit, towards the light
    glm::vec3 H;           // unit, half way between L and V
    glm::vec3 R;           // L mirrored about N
    float distance;        // r; infinite for a light at infinity
    glm::vec3 intensity;   // I_p after the fall-off
    glm::vec3 body;        // the diffuse part, without shadow
    glm::vec3 highlight;   // the rest of what the model adds, without shadow
    float share;           // of the light, that reaches the pixel: 0 in shadow
    std::int32_t stencil;  // in how many shadow volumes the surface lies; 0 where none are counted
    std::optional<FacetTerms> facets;  // of Cook and Torrance's model, where light and eye are
                                       // before the surface
};

/// All that a pixel was lit by. `intensity` is that of Phong shading, linear, and the picture's own
/// where that is how its polygon is shaded.
struct PixelLight {
    std::uint32_t item;     // the face's place among those of all objects
    std::uint32_t polygon;  // its place in the file plus 1, counted on over the objects
    raster::Depth depth;
    float distance;   // from the eye along the view, world units
    glm::vec3 point;  // world space
    glm::vec3 N;      // unit, as bump and normal map leave it
    glm::vec3 V;      // unit, towards the eye
    std::optional<glm::vec3> vertex_color;
    std::vector<TextureAtPixel> textures;
    glm::vec3 K_a, K_d, K_s;  // with what colours and textures make of them
    double exponent;          // n
    glm::vec3 ambient;        // I_a K_a, what the surface sends of its own, and its surroundings
    std::vector<LightAtPixel> lights;
    glm::vec3 intensity;  // the sum
};

/// Finds out what is at pixels of one picture. Each buffer that this takes is drawn once, by the
/// textbook's walk. It takes all surfaces for opaque.
class PixelLights {
public:
    PixelLights(Scene scene, const Settings& settings, raster::Viewport viewport);

    /// Nothing where no polygon is.
    std::optional<PixelLight> at(int x, int y) const;

private:
    struct Place {
        const Object* object;
        std::size_t face;
    };
    Place place_of(std::uint32_t item) const;
    template <class Material>
    void light(PixelLight& pixel, const Material& material, const Settings& settings, int x,
               int y) const;

    Scene scene_;
    Settings settings_;
    raster::Viewport viewport_;
    raster::Plane<raster::Depth> depth_;
    raster::Plane<std::uint32_t> items_;
    raster::Plane<std::uint32_t> ids_;
    raster::Plane<float> distances_;
    std::vector<raster::Plane<float>> shares_;           // of each light; empty without shadows
    std::vector<raster::Plane<std::int32_t>> stencils_;  // of each light; empty without volumes
};

}  // namespace scanlight::render
