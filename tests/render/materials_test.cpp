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

TEST(Materials, LightOfItsOwnAndOpacity) {
    auto file = file_material(2);
    file.emission = {1.0f, 2.0f, 3.0f};
    for (const auto& [d, opacity] : {std::pair{0.25f, 0.25f}, {-1.0f, 0.0f}, {7.0f, 1.0f}}) {
        file.opacity = d;
        EXPECT_EQ(shading_material(file).emission, glm::vec3(1.0f, 2.0f, 3.0f));
        EXPECT_EQ(shading_material(file).opacity, opacity);
    }
}

TEST(Materials, IllumZeroIsTheColourWhateverTheLight) {
    const auto material = shading_material(file_material(0));
    EXPECT_EQ(material.emission, glm::vec3(0.4f, 0.5f, 0.6f));
    for (const auto& answer : {material.ambient, material.diffuse, material.specular})
        EXPECT_EQ(answer, glm::vec3(0.0f));
}

TEST(Materials, WhatIllumCannotHaveIsSaid) {
    for (const int illum : {0, 1, 2})
        EXPECT_EQ(approximation_of(illum), "") << illum;
    for (int illum = 3; illum <= 10; ++illum)
        EXPECT_NE(approximation_of(illum), "") << illum;
}

TEST(Materials, IllumOneHasNoHighlight) {
    const auto material = shading_material(file_material(1));
    EXPECT_EQ(material.specular, glm::vec3(0.0f));
    EXPECT_EQ(material.diffuse, glm::vec3(0.4f, 0.5f, 0.6f));
    for (const int illum : {2, 3, 10}) {
        EXPECT_EQ(shading_material(file_material(illum)).specular, glm::vec3(0.7f, 0.8f, 0.9f));
    }
}

TEST(Materials, AReflectionMapMakesAMirrorOfWhatHasAHighlight) {
    auto chrome = file_material(2);
    EXPECT_EQ(shading_material(chrome).mirror, glm::vec3(0.0f));
    chrome.maps[mesh::MapUse::sphere] = {};
    EXPECT_EQ(shading_material(chrome).mirror, glm::vec3(0.7f, 0.8f, 0.9f));
    chrome.illumination = 0;
    EXPECT_EQ(shading_material(chrome).mirror, glm::vec3(0.0f));
}

TEST(Materials, LightThatComesThroughIsFiltered) {
    auto glass = file_material(2);
    glass.filter = {0.1f, 0.2f, 0.3f};
    EXPECT_EQ(shading_material(glass).filter, glm::vec3(0.1f, 0.2f, 0.3f));
    glass.illumination = 0;
    EXPECT_EQ(shading_material(glass).filter, glm::vec3(0.1f, 0.2f, 0.3f));
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
