#include <gtest/gtest.h>

#include <cmath>

#include "mesh/bounds.h"
#include "mesh/shapes.h"
#include "render/texture_fit.h"
#include "shading/texture_lookup.h"
#include "tests/render/scenes.h"

namespace scanlight::render {
namespace {

/// Of the texture that a bump map of waves would show at a point of the unit sphere.
double texture_height(const glm::dvec3& direction) {
    shading::Texture waves;
    waves.pattern = shading::Pattern::waves;
    waves.mapping = shading::Mapping::spherical;
    const mesh::Box box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    waves = fitted(waves, box, Axis::y, 1.0);
    const shading::PlacedTexture placed{&waves, waves.texture_from_object};
    shading::TextureSite<double> site{direction, {}, {}, {}, {}};
    return shading::color_at(placed, site).x;
}

TEST(WavySphere, IsRaisedByTheWavesThatABumpMapShows) {
    for (const glm::vec3& p : mesh::shape("wavy-sphere:37,29").positions) {
        const double radius = glm::length(glm::dvec3(p));
        ASSERT_NEAR(radius, 1.0 + 0.03 * texture_height(glm::dvec3(p) / radius), 1e-6);
    }
}

TEST(WavySphere, IsAsHighAsItsWaves) {
    double highest = 0.0;
    for (const glm::vec3& p : mesh::shape("wavy-sphere").positions)
        highest = std::max(highest, glm::length(glm::dvec3(p)));
    EXPECT_NEAR(highest, 1.03, 1e-4);
}

}  // namespace
}  // namespace scanlight::render
