#include "shading/slopes.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "shading/luminance.h"

namespace scanlight::shading {

namespace {

/// The luminance of an image's finest level.
class Heights {
public:
    Heights(const TexelImage& image, Wrap wrap) : image_(image), wrap_(wrap) {}

    float slope_u(int x, int y) const { return 0.5f * (at(x + 1, y) - at(x - 1, y)); }
    float slope_v(int x, int y) const { return 0.5f * (at(x, y + 1) - at(x, y - 1)); }

private:
    float at(int x, int y) const {
        const int i = inside(x, image_.width());
        const int j = inside(y, image_.height());
        return luminance(texel_at<TexelColor<float>, float>(image_, image_.index(i, j)));
    }
    int inside(int i, int size) const {
        if (wrap_ == Wrap::repeat) return (i + size) % size;
        return std::clamp(i, 0, size - 1);
    }

    const TexelImage& image_;
    Wrap wrap_;
};

/// Across an edge of an image that ends there, a surface goes on as it is, or comes back.
bool is_edge(int i, int size, Wrap wrap) {
    return wrap != Wrap::repeat && (i == 0 || i == size - 1);
}

}  // namespace

TexelImage slopes_of(const TexelImage& image, Wrap wrap) {
    const Heights heights(image, wrap);
    const int width = image.width();
    const int height = image.height();
    std::vector<float> slopes;
    slopes.reserve(2 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = is_edge(x, width, wrap) ? 0.0f : heights.slope_u(x, y);
            const float v = is_edge(y, height, wrap) ? 0.0f : heights.slope_v(x, y);
            slopes.insert(slopes.end(), {u, v});
        }
    }
    return TexelImage::of_slopes(width, height, slopes);
}

}  // namespace scanlight::shading
