#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/bounds.h"
#include "render/texture_fit.h"
#include "shading/surface_textures.h"

namespace scanlight::apps {

/// Which of a material's attributes a texture changes.
enum class TextureSlot { ambient, diffuse, specular, exponent, opacity, bump, normal };

/// A texture as the command line gives it.
struct TextureOption {
    TextureSlot slot = TextureSlot::diffuse;
    shading::Texture texture;
    std::string image_path;  // of Pattern::image
    render::Axis axis = render::Axis::y;
    double scale = 1.0;
    float height = 0.05f;  // of a bump; how strong a normal map is
};

/// "SLOT=KIND [key=value…]", such as "diffuse=checker mapping=spherical count=12". Throws
/// UsageError, which shows what was expected.
TextureOption parse_texture(std::string_view text);

/// The textures on a mesh with these bounds. Throws UsageError for a file that is no picture, or
/// too large a one.
shading::SurfaceTextures textures_of(const std::vector<TextureOption>& options,
                                     const mesh::Box& bounds);

/// What `above` has, and of the rest what `below` has.
shading::SurfaceTextures laid_over(shading::SurfaceTextures below,
                                   const shading::SurfaceTextures& above);

}  // namespace scanlight::apps
