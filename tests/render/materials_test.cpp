#include "render/materials.h"

#include <gtest/gtest.h>

namespace scanlight::render {
namespace {

mesh::Material file_material(int illum) {
    mesh::Material material;
    material.ambient = {0.1f, 0.2f, 0.3f};
    material.diffuse = {0.4f, 0.5f, 0.6f};
    material.specular = {0.7f, 0.8f, 0.9f};
    material.exponent = 42.0f;
    material.illumination = illum;
    return material;
}

TEST(Materials, FileNamesBecomeTheModelsLetters) {
    const auto material = shading_material(file_material(2));
    EXPECT_EQ(material.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(material.diffuse, glm::vec3(0.4f, 0.5f, 0.6f));
    EXPECT_EQ(material.specular, glm::vec3(0.7f, 0.8f, 0.9f));
    EXPECT_EQ(material.exponent.value(), 42.0);
}

TEST(Materials, IllumBelowTwoHasNoHighlight) {
    for (const int illum : {0, 1}) {
        const auto material = shading_material(file_material(illum));
        EXPECT_EQ(material.specular, glm::vec3(0.0f));
        EXPECT_EQ(material.diffuse, glm::vec3(0.4f, 0.5f, 0.6f));
    }
    for (const int illum : {2, 3, 10}) {
        EXPECT_EQ(shading_material(file_material(illum)).specular, glm::vec3(0.7f, 0.8f, 0.9f));
    }
}

TEST(Materials, FacetsHaveTheFilesIndexWhereItIsOne) {
    auto glass = file_material(2);
    glass.refraction = 1.7f;
    EXPECT_NEAR(shading_material(glass).facets.reflectance.n.x, 1.7, 1e-6);
    EXPECT_EQ(shading_material(file_material(2)).facets.reflectance.n.x, 1.5);
}

TEST(Materials, KeepTheirOrder) {
    auto first = file_material(2);
    first.exponent = 1.0f;
    const auto materials = shading_materials({first, file_material(2)});
    ASSERT_EQ(materials.size(), 2u);
    EXPECT_EQ(materials[0].exponent.value(), 1.0);
    EXPECT_EQ(materials[1].exponent.value(), 42.0);
}

}  // namespace
}  // namespace scanlight::render
