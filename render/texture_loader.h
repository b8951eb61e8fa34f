#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "raster/image.h"
#include "render/image_channel.h"
#include "render/texture_image.h"
#include "shading/sampling.h"

namespace scanlight::render {

/// The picture of this name, as a material gives it. Throws a std::runtime_error whose what() is
/// the reason why there is none.
using LoadImage = std::function<raster::AnyImage(const std::string& path)>;

/// A picture as a texture wants it. Those of one file are neighbours in their order.
struct WantedTexture {
    std::string path;  // never empty
    TexelMeaning meaning;
    ImageChannel channel;
    RowAtZero zero = RowAtZero::lowest;
    std::optional<shading::Wrap> slopes = {};  // of heights: how they go on beyond the edges

    auto operator<=>(const WantedTexture&) const = default;
};

/// A texture's texels, or why there are none.
struct LoadedTexture {
    std::shared_ptr<const shading::TexelImage> image;
    std::string reason;
};

using LoadedTextures = std::map<WantedTexture, LoadedTexture>;

/// Makes textures as long as there is room. It keeps the latest file for its next use.
class TextureLoader {
public:
    TextureLoader(const LoadImage& load, std::size_t most_bytes)
        : load_(load), most_bytes_(most_bytes) {}

    LoadedTexture loaded(const WantedTexture& wanted);

private:
    void read(const std::string& path);
    bool has_room() const;

    const LoadImage& load_;
    std::size_t most_bytes_;
    std::size_t bytes_ = 0;
    std::string path_;
    std::optional<raster::AnyImage> picture_;
    std::string failure_;
};

}  // namespace scanlight::render
