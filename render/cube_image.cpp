#include "render/cube_image.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <variant>

#include "render/texture_image.h"

namespace scanlight::render {

namespace {

/// Where a side lies: in which square of the picture.
struct Square {
    int column, row;
    bool upside_down = false;
};

/// How the sides lie: +x -x +y -y +z -z.
struct Shape {
    int columns, rows;
    Square squares[6];
};

constexpr Shape shapes[] = {{6, 1, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}},
                            {1, 6, {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}},
                            {4, 3, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}},
                            {3, 4, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3, true}}}};

/// Null where the picture has none of them.
const Shape* shape_of(int width, int height) {
    const auto* const shape = std::ranges::find_if(shapes, [&](const Shape& s) {
        return width % s.columns == 0 && width / s.columns * s.rows == height;
    });
    return shape == std::end(shapes) ? nullptr : shape;
}

template <class Sample>
raster::Image<Sample> cut(const raster::Image<Sample>& picture, const Square& square, int side) {
    raster::Image<Sample> result(side, side, picture.channels());
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int i = square.upside_down ? side - 1 - x : x;
            const int j = square.upside_down ? side - 1 - y : y;
            std::ranges::copy(picture.pixel(square.column * side + i, square.row * side + j),
                              result.pixel(x, y).begin());
        }
    }
    return result;
}

}  // namespace

std::optional<CubeSides> cube_sides(const raster::AnyImage& picture) {
    return std::visit(
        [](const auto& pixels) -> std::optional<CubeSides> {
            const Shape* const shape = shape_of(pixels.width(), pixels.height());
            if (shape == nullptr) return std::nullopt;
            const int side = pixels.width() / shape->columns;
            CubeSides sides;
            for (std::size_t i = 0; i < sides.size(); ++i)
                sides[i] = cut(pixels, shape->squares[i], side);
            return sides;
        },
        picture);
}

std::optional<shading::Environment> cube_environment(const CubeSides& sides) {
    shading::Environment environment{shading::EnvironmentLayout::cube, {}, cube_from_world};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        environment.images[i] = texel_image(sides[i], TexelMeaning::color, RowAtZero::highest);
        if (environment.images[i] == nullptr) return std::nullopt;
    }
    return environment;
}

}  // namespace scanlight::render
