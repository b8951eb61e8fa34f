#include "apps/peers/gl_texture.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "shading/slopes.h"

namespace scanlight::peers {

namespace {

/// OpenGL's first row is the lowest.
std::vector<std::uint8_t> rows_from_below(const raster::Image8& image) {
    std::vector<std::uint8_t> bytes;
    for (int y = image.height(); y-- > 0;) {
        const auto row = image.row(y);
        bytes.insert(bytes.end(), row.begin(), row.end());
    }
    return bytes;
}

void upload_colors() {
    const raster::Image8 image = coat_image(Coat::texture);
    const auto bytes = rows_from_below(image);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image.width(), image.height(), 0, GL_RGB,
                 GL_UNSIGNED_BYTE, bytes.data());
}

/// As 16-bit floats.
void upload_slopes() {
    const auto image = coat_textures(Coat::bump).bump->image;
    std::vector<float> slopes;
    for (int y = 0; y < image->height(); ++y) {
        for (int x = 0; x < image->width(); ++x) {
            const auto [u, v] =
                shading::texel_at<shading::TexelSlopes<float>, float>(*image, image->index(x, y));
            slopes.insert(slopes.end(), {u, v});
        }
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, image->width(), image->height(), 0, GL_RG, GL_FLOAT,
                 slopes.data());
}

}  // namespace

GLuint gl_texture(Coat coat) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    coat == Coat::bump ? upload_slopes() : upload_colors();
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace scanlight::peers
