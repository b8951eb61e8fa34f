#include "apps/peers/coat.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "render/texture_image.h"
#include "shading/slopes.h"

namespace scanlight::peers {

namespace {

constexpr int side = 256;
constexpr int tile = 32;

/// 0 at a tile's border, growing to 255 within some texels of it.
int dome(int x, int y) {
    const auto from_border = [](int i) { return std::min(i % tile, tile - 1 - i % tile); };
    return std::min(255, 40 * std::min(from_border(x), from_border(y)));
}

std::uint8_t byte(int value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

/// Tiles, each of its own shade.
void paint_tiles(raster::Image8& image) {
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int shade = 37 * (x / tile) + 61 * (y / tile);
            const int light = dome(x, y) / 2 + 64;
            const auto pixel = image.pixel(x, y);
            pixel[0] = byte(light + shade % 64);
            pixel[1] = byte(light + shade / 3 % 48);
            pixel[2] = byte(light + shade / 7 % 32);
        }
    }
}

void raise_tiles(raster::Image8& image) {
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x)
            image.pixel(x, y)[0] = byte(dome(x, y));
    }
}

}  // namespace

raster::Image8 coat_image(Coat coat) {
    raster::Image8 image(side, side, coat == Coat::bump ? 1 : 3);
    coat == Coat::bump ? raise_tiles(image) : paint_tiles(image);
    return image;
}

shading::SurfaceTextures coat_textures(Coat coat) {
    shading::SurfaceTextures textures;
    if (coat == Coat::none) return textures;
    const bool is_bump = coat == Coat::bump;
    shading::Texture texture;
    texture.pattern = shading::Pattern::image;
    texture.repeat = glm::vec2(coat_repeat);
    texture.image = render::texel_image(
        coat_image(coat), is_bump ? render::TexelMeaning::value : render::TexelMeaning::color);
    if (is_bump) {
        texture.image = std::make_shared<const shading::TexelImage>(
            shading::slopes_of(*texture.image, texture.wrap));
    }
    textures.bump_height = coat_height;
    (is_bump ? textures.bump : textures.diffuse) = texture;
    return textures;
}

}  // namespace scanlight::peers
