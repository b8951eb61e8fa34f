#include "render/cube_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scanlight::render {
namespace {

/// Squares of 2 x 2 pixels by letters, a row of squares a line; a letter's number from "a" is its
/// grey, the lower right pixel 100 more.
raster::ImageF picture_of(const std::vector<std::string>& squares) {
    const int columns = static_cast<int>(squares.front().size());
    const int rows = static_cast<int>(squares.size());
    raster::ImageF image(2 * columns, 2 * rows, 1);
    for (int y = 0; y < 2 * rows; ++y) {
        for (int x = 0; x < 2 * columns; ++x) {
            const char letter =
                squares[static_cast<std::size_t>(y / 2)][static_cast<std::size_t>(x / 2)];
            const bool is_last = x % 2 == 1 && y % 2 == 1;
            image.pixel(x, y)[0] = static_cast<float>(letter - 'a' + (is_last ? 100 : 0));
        }
    }
    return image;
}

const raster::ImageF& side(const CubeSides& sides, std::size_t number) {
    return std::get<raster::ImageF>(sides[number]);
}

TEST(CubeImage, HasItsSidesInARowAColumnOrACross) {
    const std::vector<std::vector<std::string>> pictures{{"abcdef"},
                                                         {"a", "b", "c", "d", "e", "f"},
                                                         {".c..", "beaf", ".d.."},
                                                         {".c.", "bea", ".d.", ".f."}};
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const auto sides = cube_sides(picture_of(pictures[i]));
        ASSERT_TRUE(sides) << i;
        for (std::size_t s = 0; s < 6; ++s) {
            EXPECT_EQ(side(*sides, s).width(), 2);
            EXPECT_EQ(side(*sides, s).pixel(1, 0)[0], static_cast<float>(s)) << i;
            const bool is_turned = i == 3 && s == 5;
            EXPECT_EQ(side(*sides, s).pixel(1, 1)[0],
                      static_cast<float>(s) + (is_turned ? 0 : 100));
            EXPECT_EQ(side(*sides, s).pixel(0, 0)[0],
                      static_cast<float>(s) + (is_turned ? 100 : 0));
        }
    }
}

TEST(CubeImage, OfAnotherShapeIsNone) {
    for (const auto& [width, height] :
         {std::pair{4, 4}, {12, 3}, {6, 2}, {7, 1}, {8, 4}, {3, 3}, {2, 12 + 1}})
        EXPECT_FALSE(cube_sides(raster::Image8(width, height, 3))) << width << " x " << height;
}

/// One who stands inside and looks ahead sees what lies right in a cross on his right.
TEST(CubeImage, RightIsRight) {
    const auto environment = cube_environment(*cube_sides(picture_of({"abcdef"})));
    ASSERT_TRUE(environment);
    const glm::vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}};
    for (std::size_t s = 0; s < 6; ++s) {
        EXPECT_EQ(shading::light_from(*environment, axes[s]).x, static_cast<float>(s) + 25.0f);
        const glm::vec3 up = axes[s].y == 0.0f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, axes[s].y);
        const glm::vec3 right = glm::cross(axes[s], up);
        const glm::vec3 corner = axes[s] + 0.9f * (right - up);
        const glm::vec3 unit = corner / std::sqrt(glm::dot(corner, corner));
        EXPECT_EQ(shading::light_from(*environment, unit).x, static_cast<float>(s) + 100.0f) << s;
    }
}

}  // namespace
}  // namespace scanlight::render
