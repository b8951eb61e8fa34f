#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "raster/srgb.h"
#include "tests/raster/cases.h"
#include "tests/same_bits/pixel_view.h"
#include "tests/same_bits/plain_mesh.h"
#include "tests/same_bits/ways.h"

namespace scanlight::render {
namespace {

float from_bits(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}

/// The smallest float whose byte is `value`.
float first_of(int value) {
    std::uint32_t low = 0;  // its byte is below, that of `high` is not
    std::uint32_t high = std::bit_cast<std::uint32_t>(1.0f);
    while (high - low > 1) {
        const std::uint32_t middle = low + (high - low) / 2;
        (raster::srgb_from_linear(from_bits(middle)) < value ? low : high) = middle;
    }
    return from_bits(high);
}

void add_with_neighbours(std::vector<float>& floats, float x) {
    const float infinity = std::numeric_limits<float>::infinity();
    floats.insert(floats.end(), {std::nextafter(x, -infinity), x, std::nextafter(x, infinity)});
}

/// Where bytes change in both encodings, the ends of all ranges, and any bits at all.
std::vector<float> telling_floats() {
    using Limits = std::numeric_limits<float>;
    std::vector<float> floats{Limits::infinity(),   -Limits::infinity(), Limits::quiet_NaN(),
                              -Limits::quiet_NaN(), Limits::max(),       Limits::lowest()};
    for (const float x : {0.0f, -0.0f, Limits::denorm_min(), Limits::min(), 1.0f, -1.0f, 255.0f,
                          raster::first_srgb_cell, 0x1p31f, 0x1p32f})
        add_with_neighbours(floats, x);
    for (int value = 1; value <= 255; ++value) {
        add_with_neighbours(floats, first_of(value));
        add_with_neighbours(floats, (static_cast<float>(value) - 0.5f) / 255.0f);
    }
    raster::laws::Random random(1);
    for (int i = 0; i < 6000; ++i) {
        const auto high = static_cast<std::uint32_t>(random.between(0, 65535));
        const float any =
            from_bits(high << 16 | static_cast<std::uint32_t>(random.between(0, 65535)));
        floats.push_back(random.one_in(2) ? any : random.real(0.0f, 1.1f));
    }
    return floats;
}

/// A polygon for each pixel of the picture.
std::vector<same_bits::PlainPolygon> pixel_squares(raster::Viewport size) {
    const glm::vec3 n(0.0f, 0.0f, 1.0f);
    std::vector<same_bits::PlainPolygon> squares;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto corner = [&](int right, int down) {
                return same_bits::PlainCorner{same_bits::at_pixel(x + right, y + down, 0.0), n};
            };
            squares.push_back({{corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)},
                               n,
                               static_cast<std::uint32_t>(squares.size())});
        }
    }
    return squares;
}

/// Pixels of given intensities: under ambient light of 1 they are K_a.
same_bits::TestScene scene_of_intensities(const std::vector<float>& floats, Shading shading) {
    constexpr int width = 100;
    const auto pixels = static_cast<int>(floats.size() / 3);
    same_bits::TestScene test{{width, pixels / width}, {.shading = shading}, {}, {}};
    const auto squares = pixel_squares(test.size);
    Object object{&test.keep(same_bits::plain_mesh(squares, squares.size())), {}};
    for (std::size_t i = 0; i < squares.size(); ++i) {
        auto& material = object.materials.emplace_back();
        material.ambient = {floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]};
    }
    test.scene.objects = {object};
    test.scene.camera = same_bits::pixel_camera(test.size);
    test.scene.lighting.ambient = glm::vec3(1.0f);
    return test;
}

class PackedPicture : public testing::TestWithParam<Shading> {
protected:
    const std::vector<float> floats = telling_floats();
    const same_bits::TestScene test = scene_of_intensities(floats, GetParam());
};

bool same_number(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

TEST_P(PackedPicture, ShowsTheFloatsThatItIsMadeOf) {
    const Drawing walk = same_bits::draw(test);
    std::size_t i = 0;
    for (const raster::Rgba& color : walk.framebuffer.color.values()) {
        for (const float channel : {color.r, color.g, color.b})
            ASSERT_TRUE(same_number(channel, floats[i++]));
    }
    EXPECT_GE(i, 255u * 3 * 2);
}

TEST_P(PackedPicture, RoundsEveryFloatAsThePackerOfOnePixelDoes) {
    const Drawing walk = same_bits::draw(test);
    static constexpr int one[] = {1};
    for (Renderer& renderer : same_bits::renderers(one)) {
        for (const auto encoding : {raster::Encoding::srgb, raster::Encoding::linear}) {
            raster::Plane<raster::PackedPixel> pixels(test.size, 0);
            renderer.draw(test.scene, test.settings, pixels, encoding);
            for (std::size_t i = 0; i < pixels.values().size(); ++i) {
                const raster::Rgba& color = walk.framebuffer.color.values()[i];
                ASSERT_EQ(pixels.values()[i], raster::packed_pixel(color, encoding))
                    << renderer.instructions() << ": " << color.r << ", " << color.g << ", "
                    << color.b;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(By, PackedPicture, testing::Values(Shading::flat, Shading::phong),
                         [](const auto& info) {
                             return info.param == Shading::flat ? "Flat" : "Phong";
                         });

}  // namespace
}  // namespace scanlight::render
