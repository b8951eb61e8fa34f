#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/load_mtl.h"
#include "mesh/mtl_text.h"
#include "tests/mesh/reading.h"

namespace scanlight::mesh {
namespace {

MaterialLibrary mtl(const std::string& statement) {
    return load_mtl("newmtl a\n" + statement + "\n", "file");
}

TextureMap map_of(const std::string& statement, MapUse use = MapUse::diffuse) {
    const MaterialLibrary library = mtl(statement);
    EXPECT_TRUE(library.warnings.empty()) << library.warnings.front();
    return library.materials.at(0).maps.at(use);
}

/// Its only warning; the map itself is passed over or not.
std::string warning_of(const std::string& statement) {
    const MaterialLibrary library = mtl(statement);
    return library.warnings.size() == 1 ? library.warnings.front() : "not one warning";
}

bool has_map(const std::string& statement) {
    return !mtl(statement).materials.at(0).maps.empty();
}

TEST(MtlMaps, EachStatementHasItsUse) {
    const std::pair<std::string, MapUse> statements[] = {
        {"map_Ka", MapUse::ambient},
        {"map_Kd", MapUse::diffuse},
        {"map_Ks", MapUse::specular},
        {"map_Ke", MapUse::emission},
        {"map_Ns", MapUse::exponent},
        {"map_d", MapUse::opacity},
        {"bump", MapUse::bump},
        {"map_bump", MapUse::bump},
        {"map_Bump", MapUse::bump},
        {"norm", MapUse::normal},
        {"refl -type sphere", MapUse::sphere},
        {"refl -type cube_top", MapUse::cube_top},
        {"refl -type cube_bottom", MapUse::cube_bottom},
        {"refl -type cube_front", MapUse::cube_front},
        {"refl -type cube_back", MapUse::cube_back},
        {"refl -type cube_left", MapUse::cube_left},
        {"refl -type cube_right", MapUse::cube_right},
        {"refl", MapUse::sphere},
    };
    for (const auto& [statement, use] : statements) {
        const MaterialLibrary library = mtl(statement + " a.png");
        EXPECT_EQ(library.materials.at(0).maps.size(), 1u) << statement;
        EXPECT_EQ(library.materials.at(0).maps.at(use).path, "a.png") << statement;
    }
}

TEST(MtlMaps, NamesMayHoldBlanksBackSlashesAndDashes) {
    for (const std::string path :
         {"wood.png", "old wood.png", "textures\\old wood.png", "sub/a  b.png", "-wood.png",
          "2.png", "7", "1 2.png", "a #1.png", "wood -s 1 1 1.png", "on", "-"}) {
        EXPECT_EQ(map_of("map_Kd " + path).path, path);
        EXPECT_EQ(map_of("map_Kd -clamp on\t" + path + " \t").path, path);
    }
}

TEST(MtlMaps, OptionsMayStandInAnyOrder) {
    std::vector<std::string> options{"-s 2 3 4",  "-o 0.5 -0.25 1", "-mm 0.125 2", "-bm 3",
                                     "-clamp on", "-blendu off",    "-blendv off", "-imfchan m"};
    TextureMap expected;
    expected.path = "a b.png";
    expected.scale = {2, 3, 4};
    expected.offset = {0.5f, -0.25f, 1};
    expected.base = 0.125f;
    expected.gain = 2;
    expected.bump = 3;
    expected.clamped = true;
    expected.blended_u = expected.blended_v = false;
    expected.channel = MapChannel::matte;
    std::ranges::sort(options);
    do {
        std::string statement = "map_Kd";
        for (const std::string& option : options)
            statement += " " + option;
        ASSERT_EQ(map_of(statement + " a b.png"), expected) << statement;
    } while (std::ranges::next_permutation(options).found);
}

TEST(MtlMaps, ScalesMayHaveOneTwoOrThreeNumbers) {
    EXPECT_EQ(map_of("map_Kd -s 2 a.png").scale, glm::vec3(2, 1, 1));
    EXPECT_EQ(map_of("map_Kd -s 2 3 a.png").scale, glm::vec3(2, 3, 1));
    EXPECT_EQ(map_of("map_Kd -s 2 3 4 a.png").scale, glm::vec3(2, 3, 4));
    EXPECT_EQ(map_of("map_Kd -s 2 3 4 5").path, "5");
    EXPECT_EQ(map_of("map_Kd -s 2 3").path, "3");  // the last word is the file
    EXPECT_EQ(map_of("map_Kd -o +1 -s 2 a.png").offset, glm::vec3(1, 0, 0));
    EXPECT_EQ(map_of("map_Kd -o 1 2 -bm 2 a.png").offset, glm::vec3(1, 2, 0));
    EXPECT_EQ(map_of("map_Kd -s 2 \\\n 3 \\\n a.png").scale, glm::vec3(2, 3, 1));
}

TEST(MtlMaps, TheLatestStatementHolds) {
    EXPECT_EQ(map_of("map_Kd a.png\nmap_Kd b.png").path, "b.png");
    EXPECT_EQ(map_of("bump -bm 2 a.png\nmap_bump b.png", MapUse::bump).bump, 1.0f);
}

TEST(MtlMaps, WhatCannotBeHonouredIsAWarning) {
    EXPECT_EQ(warning_of("disp a.png"), "file:2: disp gives a displacement, which is passed over");
    EXPECT_EQ(warning_of("decal a.png"), "file:2: decal gives a decal, which is passed over");
    EXPECT_EQ(warning_of("map_Kd -t 1 2 a.png"), "file:2: -t of map_Kd is passed over");
    EXPECT_EQ(warning_of("map_Kd -texres 512 a.png"), "file:2: -texres of map_Kd is passed over");
    EXPECT_EQ(warning_of("map_Kd -boost 2 a.png"), "file:2: -boost of map_Kd is passed over");
    EXPECT_EQ(warning_of("map_Kd -cc on a.png"), "file:2: -cc of map_Kd is passed over");
    EXPECT_EQ(warning_of("map_Kd -wrap on a.png"),
              "file:2: map_Kd has an unknown option \"-wrap\": it is passed over");
    EXPECT_EQ(warning_of("map_Kd"), "file:2: map_Kd names no file: it is passed over");
    EXPECT_EQ(warning_of("map_Kd  # none"), "file:2: map_Kd names no file: it is passed over");
    EXPECT_EQ(warning_of("map_Bump -bm 1"), "file:2: map_Bump names no file: it is passed over");
    EXPECT_EQ(warning_of("Pr 0.5\nPr 0.5\nPr 1"),
              "file:2: statement \"Pr\" is passed over, the first of 3");
    EXPECT_TRUE(has_map("map_Kd -t 1 2 a.png"));
    EXPECT_TRUE(has_map("map_Kd -cc on -texres 8 -boost 1 a.png"));
    for (const std::string statement : {"disp a.png", "map_Kd -wrap on a.png", "map_Kd"})
        EXPECT_FALSE(has_map(statement)) << statement;
}

TEST(MtlMaps, BadOptionsGetOneClearMessage) {
    const std::vector<BadFile> files{
        {"map_Kd a.png\n", "file:1: map_Kd before the first newmtl"},
        {"bump a.png\n", "file:1: bump before the first newmtl"},
        {"refl -type sphere a.png\n", "file:1: refl before the first newmtl"},
        {"norm a.png\nnewmtl a\n", "file:1: norm before the first newmtl"},
        {"newmtl a\nmap_Kd -s\n", "file:2: a number is missing"},
        {"newmtl a\nmap_Kd -s a.png\n", "file:2: \"a.png\" is not a number"},
        {"newmtl a\nmap_Kd -s 1x a.png\n", "file:2: \"1x\" is not a number"},
        {"newmtl a\nmap_Kd -s nan a.png\n", "file:2: \"nan\" is not a finite number"},
        {"newmtl a\nmap_Kd -s 1 inf a.png\n", "file:2: \"inf\" is not a finite number"},
        {"newmtl a\nmap_Kd -s 1 1e99 a.png\n", "file:2: \"1e99\" is out of range"},
        {"newmtl a\nmap_Kd -s 1 1 1e999 a.png\n", "file:2: \"1e999\" is out of range"},
        {"newmtl a\nmap_Kd -o\n", "file:2: a number is missing"},
        {"newmtl a\nmap_Kd -o left a.png\n", "file:2: \"left\" is not a number"},
        {"newmtl a\nmap_Kd -t\n", "file:2: a number is missing"},
        {"newmtl a\nmap_Kd -mm 1\n", "file:2: a number is missing"},
        {"newmtl a\nmap_Kd -mm 1 a.png\n", "file:2: \"a.png\" is not a number"},
        {"newmtl a\nmap_Ks -mm a.png\n", "file:2: \"a.png\" is not a number"},
        {"newmtl a\nbump -bm a.png\n", "file:2: \"a.png\" is not a number"},
        {"newmtl a\nbump -bm\n", "file:2: a number is missing"},
        {"newmtl a\nbump -bm 1e40 a.png\n", "file:2: \"1e40\" is out of range"},
        {"newmtl a\nmap_d -clamp a.png\n", "file:2: \"a.png\" is neither on nor off"},
        {"newmtl a\nmap_d -clamp\n", "file:2: \"\" is neither on nor off"},
        {"newmtl a\nmap_d -clamp true a.png\n", "file:2: \"true\" is neither on nor off"},
        {"newmtl a\nmap_d -blendu 1 a.png\n", "file:2: \"1\" is neither on nor off"},
        {"newmtl a\nmap_d -blendv ON a.png\n", "file:2: \"ON\" is neither on nor off"},
        {"newmtl a\nmap_d -cc maybe a.png\n", "file:2: \"maybe\" is neither on nor off"},
        {"newmtl a\nmap_d -imfchan a a.png\n", "file:2: \"a\" is not r, g, b, m, l or z"},
        {"newmtl a\nmap_d -imfchan\n", "file:2: \"\" is not r, g, b, m, l or z"},
        {"newmtl a\nrefl -type cube a.png\n",
         "file:2: \"cube\" is not sphere or a side such as cube_top"},
        {"newmtl a\nrefl -type a.png\n",
         "file:2: \"a.png\" is not sphere or a side such as cube_top"},
        {"newmtl a\nmap_Kd -texres big a.png\n", "file:2: \"big\" is not a number"},
        {"newmtl a\nmap_Kd -boost a.png\n", "file:2: \"a.png\" is not a number"},
        {"newmtl a\nKd 1 0 0\n\nnewmtl b\nmap_Kd -s 1 1 1 -clamp of a b.png\n",
         "file:5: \"of\" is neither on nor off"},
    };
    for (const BadFile& file : files)
        EXPECT_EQ(read_error("mtl", file.bytes), file.message) << file.bytes;
}

// ---- what is written is read back the same

class RandomMaterials {
public:
    explicit RandomMaterials(unsigned seed) : random_(seed) {}

    Material material(int number) {
        Material m;
        m.name = "m " + std::to_string(number);
        for (auto color : {&Material::ambient, &Material::diffuse, &Material::specular,
                           &Material::emission, &Material::filter}) {
            m.*color = vector();
        }
        for (auto value : {&Material::exponent, &Material::opacity, &Material::refraction})
            m.*value = number_of_any_size();
        m.illumination = static_cast<int>(random_() % 11);
        for (int use = 0; use <= static_cast<int>(MapUse::cube_right); ++use) {
            if (random_() % 3 == 0) m.maps[static_cast<MapUse>(use)] = map();
        }
        return m;
    }

private:
    bool coin() { return random_() % 2 == 0; }
    float number_of_any_size() {
        const float digits = static_cast<float>(random_()) / 65536.0f - 32768.0f;
        return coin() ? digits : std::ldexp(digits, static_cast<int>(random_() % 160) - 140);
    }
    glm::vec3 vector() {
        const float x = number_of_any_size();
        const float y = number_of_any_size();
        return {x, y, number_of_any_size()};
    }

    TextureMap map() {
        const std::string paths[] = {"a.png", "-a.png", "b\\c d.png", "2 3.jpg", "dir/on", "a #b"};
        TextureMap m;
        m.path = paths[random_() % 6];
        if (coin()) m.scale = vector();
        if (coin()) m.offset = vector();
        if (coin()) m.base = number_of_any_size();
        if (coin()) m.gain = number_of_any_size();
        if (coin()) m.bump = number_of_any_size();
        m.clamped = coin();
        m.blended_u = coin();
        m.blended_v = coin();
        if (coin()) m.channel = static_cast<MapChannel>(random_() % 6);
        return m;
    }

    std::mt19937 random_;
};

TEST(MtlText, IsReadBackTheSame) {
    RandomMaterials random(1);
    std::vector<Material> materials;
    for (int i = 0; i < 500; ++i)
        materials.push_back(random.material(i));
    const std::string text = mtl_text(materials);
    const MaterialLibrary library = load_mtl(text, "file");
    EXPECT_TRUE(library.warnings.empty()) << library.warnings.front();
    ASSERT_EQ(library.materials.size(), materials.size());
    for (std::size_t i = 0; i < materials.size(); ++i)
        EXPECT_EQ(library.materials[i], materials[i]) << mtl_text({&materials[i], 1});
    EXPECT_EQ(mtl_text(library.materials), text);
}

TEST(MtlText, SaysOnlyWhatIsUnusualOfAMap) {
    const MaterialLibrary library =
        mtl("Kd 0.5\nTr 0.25\nmap_Bump -mm 0 1 -s 2 -bm 0.5 -clamp off a b.png\n"
            "refl -type cube_top c.png");
    EXPECT_EQ(mtl_text(library.materials),
              "newmtl a\nKa 0.2 0.2 0.2\nKd 0.5 0.5 0.5\nKs 0 0 0\nKe 0 0 0\nTf 1 1 1\nNs 1\nNi 1\n"
              "d 0.75\nillum 2\nbump -s 2 1 1 -bm 0.5 a b.png\nrefl -type cube_top c.png\n");
}

TEST(MtlText, LeavesOutWhatHasNoName) {
    EXPECT_EQ(mtl_text(std::vector<Material>(2)), "");
}

}  // namespace
}  // namespace scanlight::mesh
