#include "render/texture_loader.h"

#include <stdexcept>
#include <variant>

#include "shading/slopes.h"

namespace scanlight::render {

LoadedTexture TextureLoader::loaded(const WantedTexture& wanted) {
    if (wanted.path != path_) read(wanted.path);
    if (!picture_) return {nullptr, failure_};
    if (!has_room()) {
        return {nullptr, wanted.path + ": the textures take more than " +
                             std::to_string(most_bytes_ >> 20) + " MiB together"};
    }
    auto image = texel_image(channel_of(*picture_, wanted.channel), wanted.meaning, wanted.zero);
    if (!image) {
        return {nullptr,
                wanted.path + ": a texture has at most " + std::to_string(most_texels) + " texels"};
    }
    if (wanted.slopes) {
        image =
            std::make_shared<const shading::TexelImage>(shading::slopes_of(*image, *wanted.slopes));
    }
    bytes_ += image->bytes();
    return {image, {}};
}

void TextureLoader::read(const std::string& path) {
    path_ = path;
    picture_.reset();
    try {
        picture_ = load_(path);
    } catch (const std::runtime_error& error) {
        failure_ = error.what();
    }
}

/// A texel takes no more than 16 bytes, and its pyramid a third of that.
bool TextureLoader::has_room() const {
    const auto texels_of = [](const auto& picture) {
        return static_cast<std::size_t>(picture.width()) *
               static_cast<std::size_t>(picture.height());
    };
    return bytes_ + std::visit(texels_of, *picture_) * 64 / 3 <= most_bytes_;
}

}  // namespace scanlight::render
