#include "apps/peers/gl_texture.h"

#include <algorithm>
#include <cstdint>
#include <vector>

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

}  // namespace

GLuint gl_texture(Coat coat) {
    const raster::Image8 image = coat_image(coat);
    const auto bytes = rows_from_below(image);
    const bool is_bump = coat == Coat::bump;
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, is_bump ? GL_R8 : GL_SRGB8_ALPHA8, image.width(), image.height(),
                 0, is_bump ? GL_RED : GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace scanlight::peers
