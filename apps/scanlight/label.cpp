#include "apps/scanlight/label.h"

#include <algorithm>
#include <vector>

#include <stb_easy_font.h>

namespace scanlight::apps {

namespace {

/// The font's letters are made of boxes, each of four of these.
struct FontVertex {
    float x, y, z;
    std::uint8_t color[4];
};

std::vector<FontVertex> boxes_of(std::string text) {
    constexpr std::size_t bytes_a_letter = 512;  // twice what the font says it takes on average
    std::vector<FontVertex> vertices((text.size() + 1) * bytes_a_letter / sizeof(FontVertex));
    const auto bytes = static_cast<int>(vertices.size() * sizeof(FontVertex));
    const int boxes = stb_easy_font_print(0.0f, 0.0f, text.data(), nullptr, vertices.data(), bytes);
    vertices.resize(4 * static_cast<std::size_t>(boxes));
    return vertices;
}

}  // namespace

void fill_box(raster::Image8& picture, int x, int y, int width, int height, const Color8& color) {
    for (int j = std::max(y, 0); j < std::min(y + height, picture.height()); ++j) {
        for (int i = std::max(x, 0); i < std::min(x + width, picture.width()); ++i)
            std::ranges::copy(color, picture.pixel(i, j).begin());
    }
}

void write_text(raster::Image8& picture, int x, int y, const std::string& text,
                const Color8& color) {
    const auto vertices = boxes_of(text);
    for (std::size_t i = 0; i < vertices.size(); i += 4) {
        const FontVertex& first = vertices[i];
        const FontVertex& last = vertices[i + 2];
        fill_box(picture, x + static_cast<int>(first.x), y + static_cast<int>(first.y),
                 static_cast<int>(last.x - first.x), static_cast<int>(last.y - first.y), color);
    }
}

int text_width(const std::string& text) {
    return stb_easy_font_width(std::string(text).data());
}

}  // namespace scanlight::apps
