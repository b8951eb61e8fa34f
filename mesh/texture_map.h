#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace scanlight::mesh {

/// What a texture map changes, by the MTL statement that names it.
enum class MapUse {
    ambient,   // map_Ka
    diffuse,   // map_Kd
    specular,  // map_Ks
    emission,  // map_Ke
    exponent,  // map_Ns
    opacity,   // map_d
    bump,      // bump, map_bump
    normal,    // norm
    sphere,    // refl -type sphere, and the six sides of a cube
    cube_top,
    cube_bottom,
    cube_front,
    cube_back,
    cube_left,
    cube_right,
};

/// Where one number is wanted of a picture, which of them: -imfchan r, g, b, m, l or z.
enum class MapChannel { red, green, blue, matte, luminance, depth };

/// A picture file, and how it is laid on a surface, as an MTL statement says it.
struct TextureMap {
    std::string path;                   // as written: perhaps with blanks and back slashes
    glm::vec3 scale{1.0f};              // -s
    glm::vec3 offset{0.0f};             // -o
    float base = 0.0f;                  // -mm, what is added to its numbers,
    float gain = 1.0f;                  //      and what they are multiplied by before
    float bump = 1.0f;                  // -bm
    bool clamped = false;               // -clamp: laid once, not again and again
    bool blended_u = true;              // -blendu, -blendv
    bool blended_v = true;              //
    std::optional<MapChannel> channel;  // -imfchan

    bool operator==(const TextureMap&) const = default;
};

}  // namespace scanlight::mesh
