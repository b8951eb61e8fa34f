#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "apps/scene/stated.h"
#include "mesh/bounds.h"
#include "render/texture_fit.h"
#include "render/texture_image.h"
#include "shading/surface_textures.h"

namespace scanlight::apps {

/// Which of a material's attributes a texture changes.
enum class TextureSlot { ambient, diffuse, specular, exponent, opacity, bump, normal };

/// A texture as a command line or a scene file gives it: for any slot.
struct TextureOption {
    std::string name;  // by which surfaces name it
    shading::Texture texture;
    std::string image_path;  // of Pattern::image
    render::Axis axis = render::Axis::y;
    double scale = 1.0;
    float height = 0.05f;  // of a bump
    Stated stated;
};

/// "SLOT=KIND [key=value…]", such as "diffuse=checker mapping=spherical count=12". Throws
/// UsageError, which shows what was expected.
std::pair<TextureSlot, TextureOption> parse_texture(std::string_view text);

/// The names of a surface's textures, one a slot; empty where there is none.
class SlotNames {
public:
    std::string& operator[](TextureSlot slot) { return names_[static_cast<std::size_t>(slot)]; }
    const std::string& operator[](TextureSlot slot) const {
        return names_[static_cast<std::size_t>(slot)];
    }
    auto begin() const { return names_.begin(); }
    auto end() const { return names_.end(); }

private:
    std::array<std::string, 7> names_;
};

/// What `above` names, and of the rest what `below` names.
SlotNames laid_over(SlotNames below, const SlotNames& above);

/// Image files as textures, each read once.
class TextureImages {
public:
    using Image = std::shared_ptr<const shading::TexelImage>;

    /// Throws UsageError for a file that is no picture, or too large a one.
    Image image(const TextureOption& option, TextureSlot slot);

private:
    Image slopes(const TextureOption& option, const Image& heights);

    std::map<std::pair<std::string, render::TexelMeaning>, Image> images_;
    std::map<std::pair<std::string, shading::Wrap>, Image> slopes_;
};

/// Puts a texture on a mesh with these bounds.
void put(const TextureOption& option, TextureSlot slot, const mesh::Box& bounds,
         TextureImages& images, shading::SurfaceTextures& textures);

/// What `above` has, and of the rest what `below` has.
shading::SurfaceTextures laid_over(shading::SurfaceTextures below,
                                   const shading::SurfaceTextures& above);

}  // namespace scanlight::apps
