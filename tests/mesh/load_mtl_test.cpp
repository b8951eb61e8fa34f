#include "mesh/load_mtl.h"

#include <gtest/gtest.h>

#include "tests/mesh/reading.h"

namespace scanlight::mesh {
namespace {

MaterialLibrary mtl(const std::string& text) {
    return load_mtl(text, "file");
}

TEST(LoadMtl, ReadsEveryParameterOfTheChapter) {
    const Material m = mtl("newmtl shiny red\n\tKa 0.1 0.2 0.3\nKd 1 0 0 # red\nKs 0.5 0.5 0.25\n"
                           "Ns 96.5\nNi 1.5\nd 0.75\nillum 3\nKe 1 2 3\nTf 0.5 0.25 1\n")
                           .materials.at(0);
    EXPECT_EQ(m.name, "shiny red");
    EXPECT_EQ(m.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(m.specular, glm::vec3(0.5f, 0.5f, 0.25f));
    EXPECT_EQ(m.exponent, 96.5f);
    EXPECT_EQ(m.refraction, 1.5f);
    EXPECT_EQ(m.opacity, 0.75f);
    EXPECT_EQ(m.illumination, 3);
    EXPECT_EQ(m.emission, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.filter, glm::vec3(0.5f, 0.25f, 1));
}

TEST(LoadMtl, OneNumberIsAGrey) {
    EXPECT_EQ(mtl("newmtl a\nKd 0.5\n").materials.at(0).diffuse, glm::vec3(0.5f));
}

TEST(LoadMtl, EachMaterialStartsFromTheDefaults) {
    const MaterialLibrary library = mtl("newmtl a\nKd 1 0 0\nd 0.5\nnewmtl b\nTr 0.25\n");
    EXPECT_EQ(library.materials.at(1).diffuse, Material{}.diffuse);
    EXPECT_EQ(library.materials.at(1).opacity, 0.75f);
    EXPECT_TRUE(library.warnings.empty());
}

TEST(LoadMtl, DissolveOutranksTransparencyInEitherOrder) {
    const MaterialLibrary after = mtl("newmtl a\nd 0.25\nTr 0.25\n");
    EXPECT_EQ(after.materials.at(0).opacity, 0.25f);
    EXPECT_EQ(after.warnings.at(0),
              "file:3: Tr gives a value at odds with d, which is passed over");
    EXPECT_EQ(mtl("newmtl a\nTr 0.25\nd 0.25\n").materials.at(0).opacity, 0.25f);
    EXPECT_TRUE(mtl("newmtl a\nd 0.25\nTr 0.75\n").warnings.empty());
}

TEST(LoadMtl, WhatItCannotHonourIsAWarning) {
    const MaterialLibrary library =
        mtl("newmtl a\nKa spectral x.rfl\nKs xyz 1 1 1\nd -halo 0.5\nillum 11\n");
    EXPECT_EQ(library.warnings.size(), 4u);
    EXPECT_EQ(library.warnings.at(0), "file:2: Ka gives a spectral curve, which is passed over");
    EXPECT_EQ(library.materials.at(0).ambient, Material{}.ambient);
    EXPECT_EQ(library.materials.at(0).opacity, 0.5f);
    EXPECT_EQ(library.materials.at(0).illumination, Material{}.illumination);
}

TEST(LoadMtl, WarningsHaveABound) {
    std::string text = "newmtl a\n";
    for (int i = 0; i < 1000; ++i)
        text += "illum 99\nword" + std::to_string(i) + " 1\n";
    const std::vector<std::string> warnings = mtl(text).warnings;
    EXPECT_EQ(warnings.size(), 20u);
    EXPECT_EQ(warnings.at(0),
              "file:2: illum gives a model other than 0 to 10, which is passed over, the first of "
              "1000");
}

TEST(LoadMtl, BadFilesGetOneClearMessage) {
    const std::vector<BadFile> files{
        {"newmtl\n", "file:1: newmtl has no name"},
        {"newmtl  \t\n", "file:1: newmtl has no name"},
        {"Kd 1 1 1\n", "file:1: Kd before the first newmtl"},
        {"Ka 1 1 1\nnewmtl a\n", "file:1: Ka before the first newmtl"},
        {"Ks 0\n", "file:1: Ks before the first newmtl"},
        {"Ns 0\n", "file:1: Ns before the first newmtl"},
        {"Ni 0\n", "file:1: Ni before the first newmtl"},
        {"d 0\n", "file:1: d before the first newmtl"},
        {"d -halo 0\n", "file:1: d before the first newmtl"},
        {"Tr 0\n", "file:1: Tr before the first newmtl"},
        {"illum 0\n", "file:1: illum before the first newmtl"},
        {"newmtl a\nKd\n", "file:2: a number is missing"},
        {"newmtl a\nKd 1 1\n", "file:2: a number is missing"},
        {"newmtl a\nKd 1 1 1 1\n", "file:2: Kd has too many numbers"},
        {"newmtl a\nKa red\n", "file:2: \"red\" is not a number"},
        {"newmtl a\nKs 1 x 1\n", "file:2: \"x\" is not a number"},
        {"newmtl a\nKs 1 1 nan\n", "file:2: \"nan\" is not a finite number"},
        {"newmtl a\nNs\n", "file:2: a number is missing"},
        {"newmtl a\nNs 1 2\n", "file:2: Ns has too many numbers"},
        {"newmtl a\nNs 1e39\n", "file:2: \"1e39\" is out of range"},
        {"newmtl a\nNs inf\n", "file:2: \"inf\" is not a finite number"},
        {"newmtl a\nd\n", "file:2: a number is missing"},
        {"newmtl a\nd -halo\n", "file:2: a number is missing"},
        {"newmtl a\nd half\n", "file:2: \"half\" is not a number"},
        {"newmtl a\nd 1 1\n", "file:2: d has too many numbers"},
        {"newmtl a\nTr\n", "file:2: a number is missing"},
        {"newmtl a\nTr 0 0\n", "file:2: Tr has too many numbers"},
        {"newmtl a\nNi -\n", "file:2: \"-\" is not a number"},
        {"newmtl a\nillum\n", "file:2: a number is missing"},
        {"newmtl a\nillum 2.5\n", "file:2: \"2.5\" is not an integer"},
        {"newmtl a\nillum 2 2\n", "file:2: illum has too many numbers"},
        {"newmtl a\nillum 99999999999999999999\n",
         "file:2: \"99999999999999999999\" is out of range"},
        {"newmtl a\nKe\n", "file:2: a number is missing"},
        {"newmtl a\nKe 1 1\n", "file:2: a number is missing"},
        {"newmtl a\nKe 1 1 1 1\n", "file:2: Ke has too many numbers"},
        {"newmtl a\nTf white\n", "file:2: \"white\" is not a number"},
        {"newmtl a\nTf 1 1 inf\n", "file:2: \"inf\" is not a finite number"},
        {"Ke 1 1 1\n", "file:1: Ke before the first newmtl"},
        {"Tf 1 1 1\n", "file:1: Tf before the first newmtl"},
        {std::string("newmtl a\0\n", 10), "file:1: a zero byte: this is not a text file"},
    };
    for (const BadFile& file : files)
        EXPECT_EQ(read_error("mtl", file.bytes), file.message);
}

}  // namespace
}  // namespace scanlight::mesh
