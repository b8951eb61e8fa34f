#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "mesh/mesh.h"
#include "mesh/silhouette.h"
#include "raster/framebuffer.h"
#include "render/camera.h"
#include "shading/environment.h"
#include "shading/illumination.h"
#include "shading/material.h"
#include "shading/surface_textures.h"

namespace scanlight::render {

enum class Shading { flat, gouraud, phong };

/// Whether attributes run evenly over the screen, as in the chapter, or over the object.
enum class Perspective { affine, correct };

/// Which polygons to leave out, by the way they face.
enum class Cull { none, back, front };

/// A surface lit on its front only, or on the side that is seen: then the normal of a polygon
/// that shows its back is turned round.
enum class Sides { one, two };

/// Where the eye and the lights are for the illumination: at their places, or at infinity, where
/// their directions are the same for every point (the chapter's simplification).
enum class Distances { finite, infinite };

/// How shadows are found.
enum class Shadows {
    none,
    zpass,            // shadow volumes, counted from the eye to the surface
    zpass_from_zero,  // the same without a thought to where the eye is: wrong in a shadow
    zfail,            // shadow volumes, counted from infinity back to the surface
    map,              // a z-buffer of what the light sees
    polygons,         // the parts of polygons that the light sees, as polygons
};

constexpr bool counts_volumes(Shadows shadows) {
    return shadows == Shadows::zpass || shadows == Shadows::zpass_from_zero ||
           shadows == Shadows::zfail;
}

/// How a shadow map is drawn and asked: see `ShadowMap`.
struct ShadowMapRule {
    int size = 1024;    // cells along each side of a view; more than `filter`
    double bias = 1.0;  // in cells: how far beyond the map's depth a surface may still be lit
    int filter = 1;     // cells along each side of the square that answers; odd
};

struct Settings {
    Shading shading = Shading::phong;
    shading::Illumination illumination = shading::Illumination::phong;
    float gouraud71_k = 1.0f;  // of that model, in world units
    Perspective perspective = Perspective::correct;
    Cull cull = Cull::none;
    Sides sides = Sides::two;
    Distances distances = Distances::finite;
    Shadows shadows = Shadows::none;
    ShadowMapRule shadow_map{};
    /// Samples a pixel, each way, of which its colour is the mean: 1, 2 or 4. Anything else that is
    /// known of a pixel, such as its depth, is that of its centre.
    int grid = 1;
};

/// What an object settles for itself; the rest is as the picture's settings say.
struct OwnSettings {
    std::optional<Shading> shading = {};
    std::optional<shading::Illumination> illumination = {};
    std::optional<float> gouraud71_k = {};
    std::optional<Perspective> perspective = {};
    std::optional<Cull> cull = {};
    std::optional<Sides> sides = {};
};

/// A mesh placed in the world. The mesh is the caller's, and outlives the object.
struct Object {
    const mesh::Mesh* mesh = nullptr;
    std::vector<shading::Material<float>> materials;  // one for each of the mesh's
    glm::dmat4 world_from_object{1.0};
    /// Of the mesh, for shadows: kept by a caller who draws it more than once. Made where null.
    const mesh::SilhouetteFinder* silhouettes = nullptr;
    /// Of each material; empty where nothing is textured.
    std::vector<shading::SurfaceTextures> textures = {};
    OwnSettings own = {};
};

struct Scene {
    Camera camera;
    shading::Lighting<float> lighting;  // world space
    std::vector<Object> objects;
    raster::Rgba background{0.0f};
    /// The light from far away: what surfaces mirror; what lights them diffusely, pre-integrated
    /// (see `shading::diffuse_environment`); what is seen behind everything, in the background's
    /// place. Any may be null. Only Phong-shaded surfaces know the first two.
    std::shared_ptr<const shading::Environment> mirrored{};
    std::shared_ptr<const shading::Environment> diffuse{};
    std::shared_ptr<const shading::Environment> surroundings{};
};

/// How an object is drawn in a picture of these settings.
inline Settings settings_of(const Object& object, Settings settings) {
    const OwnSettings& own = object.own;
    settings.shading = own.shading.value_or(settings.shading);
    settings.illumination = own.illumination.value_or(settings.illumination);
    settings.gouraud71_k = own.gouraud71_k.value_or(settings.gouraud71_k);
    settings.perspective = own.perspective.value_or(settings.perspective);
    settings.cull = own.cull.value_or(settings.cull);
    settings.sides = own.sides.value_or(settings.sides);
    return settings;
}

/// Calls `use` with the function object of the settings' illumination model.
template <class Use>
decltype(auto) with_model(const Settings& settings, Use&& use) {
    return shading::with_illumination(settings.illumination, std::forward<Use>(use),
                                      shading::Gouraud1971{settings.gouraud71_k});
}

}  // namespace scanlight::render
