#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "apps/scene/read_scene.h"
#include "apps/scene/reference.h"
#include "apps/scene/write_scene.h"
#include "tests/apps/shell.h"
#include "tests/raster/cases.h"

namespace scanlight::apps {
namespace {

SceneOptions read(const std::string& text) {
    SceneOptions options;
    read_scene(options, text, "scene.toml", "folder");
    return options;
}

TEST(SceneFile, SaysWhatTheCommandLineSays) {
    const SceneOptions o = read(R"(
        [camera]
        eye = [1, 2, 3.5]
        target = [0, 1, 0]
        up = [0, 0, 1]
        lens_mm = 50
        projection = "orthographic"
        zoom = 2
        [render]
        size = [320, 200]
        samples = 16
        shading = "flat"
        illumination = "blinn"
        interpolation = "triangulated"
        perspective = "affine"
        cull = "back"
        sides = "one"
        distances = "infinite"
        shadows = "zfail"
        normals = "angle"
        crease_deg = 45
        ambient = 0.25
        background = "none"
        floor = true
        wireframe = "over"
    )");
    EXPECT_EQ(o.eye, glm::dvec3(1.0, 2.0, 3.5));
    EXPECT_EQ(o.target, glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(o.up, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_EQ(o.lens_mm, 50.0);
    EXPECT_EQ(o.projection, render::Projection::orthographic);
    EXPECT_EQ(o.zoom, 2.0);
    EXPECT_EQ(o.size.width, 320);
    EXPECT_EQ(o.size.height, 200);
    EXPECT_EQ(o.settings.grid, 4);
    EXPECT_EQ(o.settings.shading, render::Shading::flat);
    EXPECT_EQ(o.settings.illumination, shading::Illumination::blinn);
    EXPECT_EQ(o.polygons, Polygons::triangulated);
    EXPECT_EQ(o.settings.perspective, render::Perspective::affine);
    EXPECT_EQ(o.settings.cull, render::Cull::back);
    EXPECT_EQ(o.settings.sides, render::Sides::one);
    EXPECT_EQ(o.settings.distances, render::Distances::infinite);
    EXPECT_EQ(o.settings.shadows, render::Shadows::zfail);
    EXPECT_EQ(o.normals.weight, mesh::NormalWeight::angle);
    EXPECT_EQ(o.normals.crease_deg, 45.0f);
    EXPECT_EQ(o.ambient, glm::vec3(0.25f));
    EXPECT_FALSE(o.background);
    EXPECT_TRUE(o.floor);
    EXPECT_EQ(o.wireframe_word, "over");
}

TEST(SceneFile, HoldsLightsMaterialsAndObjects) {
    const SceneOptions o = read(R"(
        [[light]]
        direction = [1, 2, 3]
        frame = "world"
        color = "#fff"
        [[light]]
        position = [0, 1, 0]
        color = [3, 2, 1]
        falloff = "inverse-plus-k"
        falloff_k = 0.5
        [[material]]
        name = "gold"
        kd = [0.5, 0.3, 0.1]
        n = 30
        [[object]]
        mesh = "../a.obj"
        material = "gold"
        scale = 2
        rotate = { axis = [1, 0, 0], deg = 90 }
        translate = [1, 0, 0]
        shading = "gouraud"
        normals = "file"
        [[object]]
        shape = "torus:8,5"
        matrix = [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]
    )");
    ASSERT_EQ(o.lights.size(), 2u);
    EXPECT_EQ(o.lights[0].frame, LightFrame::world);
    EXPECT_EQ(o.lights[0].place, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(o.lights[1].frame, LightFrame::point);
    EXPECT_EQ(o.lights[1].color, glm::vec3(3.0f, 2.0f, 1.0f));
    EXPECT_EQ(o.lights[1].falloff, shading::Falloff::inverse_plus_k);
    EXPECT_EQ(o.lights[1].falloff_k, 0.5f);
    ASSERT_EQ(o.materials.size(), 1u);
    EXPECT_EQ(o.materials[0].diffuse, glm::vec3(0.5f, 0.3f, 0.1f));
    EXPECT_FALSE(o.materials[0].ambient);
    ASSERT_EQ(o.objects.size(), 2u);
    EXPECT_EQ(o.objects[0].input, "folder/../a.obj");
    EXPECT_EQ(o.objects[0].material, "gold");
    EXPECT_EQ(o.objects[0].placement.scale, glm::dvec3(2.0));
    EXPECT_EQ(o.objects[0].placement.turns.at(0).angle_deg, 90.0);
    EXPECT_EQ(o.objects[0].own.shading, render::Shading::gouraud);
    EXPECT_FALSE(o.objects[0].own.cull);
    EXPECT_EQ(o.objects[0].normals, mesh::NormalWeight::file);
    EXPECT_EQ(o.objects[1].input, "shape:torus:8,5");
    EXPECT_EQ((*o.objects[1].placement.matrix)[3], glm::dvec4(5.0, 6.0, 7.0, 1.0));
}

TEST(SceneFile, HoldsTexturesAndWhatNamesThem) {
    const SceneOptions o = read(R"(
        [[texture]]
        name = "planks"
        image = "../planks.png"
        mapping = "planar"
        axis = "z"
        repeat = [2, 3]
        offset = 0.5
        [[texture]]
        name = "dots"
        pattern = "cubes"
        count = 5
        low = "#fff"
        height = 0.25
        [[material]]
        name = "m"
        diffuse_texture = "planks"
        bump_texture = "dots"
        [[object]]
        shape = "cube"
        material = "m"
        bump_texture = "planks"
    )");
    ASSERT_EQ(o.textures.size(), 2u);
    EXPECT_EQ(o.textures[0].image_path, "folder/../planks.png");
    EXPECT_EQ(o.textures[0].texture.pattern, shading::Pattern::image);
    EXPECT_EQ(o.textures[0].texture.mapping, shading::Mapping::planar);
    EXPECT_EQ(o.textures[0].axis, render::Axis::z);
    EXPECT_EQ(o.textures[0].texture.repeat, glm::vec2(2.0f, 3.0f));
    EXPECT_EQ(o.textures[0].texture.offset, glm::vec2(0.5f));
    EXPECT_EQ(o.textures[1].texture.pattern, shading::Pattern::solid_checker);
    EXPECT_EQ(o.textures[1].texture.count, 5.0f);
    EXPECT_EQ(o.textures[1].texture.low, glm::vec3(1.0f));
    EXPECT_EQ(o.textures[1].height, 0.25f);
    EXPECT_EQ(o.materials[0].textures[TextureSlot::diffuse], "planks");
    EXPECT_EQ(o.materials[0].textures[TextureSlot::bump], "dots");
    EXPECT_EQ(o.objects[0].textures[TextureSlot::bump], "planks");
    EXPECT_EQ(o.objects[0].textures[TextureSlot::diffuse], "");
}

TEST(SceneFile, HoldsEnvironmentShadowMapsAndFacets) {
    const SceneOptions o = read(R"(
        [environment]
        built_in = "room"
        light = true
        [render]
        shadows = "map"
        shadow_map_size = 256
        shadow_bias = 2.5
        shadow_pcf = 3
        own_textures = false
        [surface]
        mirror = 0.25
        opacity = 0.5
        metal = "silver"
        roughness = 0.4
        specular_share = 0.75
    )");
    EXPECT_EQ(o.environment.image, "room");
    EXPECT_TRUE(o.environment.lights);
    EXPECT_EQ(o.settings.shadows, render::Shadows::map);
    EXPECT_EQ(o.settings.shadow_map.size, 256);
    EXPECT_EQ(o.settings.shadow_map.bias, 2.5);
    EXPECT_EQ(o.settings.shadow_map.filter, 3);
    EXPECT_FALSE(o.own_textures);
    EXPECT_EQ(o.material.mirror, glm::vec3(0.25f));
    EXPECT_EQ(o.material.opacity, 0.5f);
    ASSERT_NE(o.material.facets.metal, nullptr);
    EXPECT_EQ(o.material.facets.metal->name, "silver");
    EXPECT_EQ(o.material.facets.roughness, 0.4);
    EXPECT_EQ(o.material.facets.specular_share, 0.75);
}

TEST(SceneFile, AFileNamedRoomIsNotTheBuiltInOne) {
    SceneOptions o;
    read_scene(o, "[environment]\nimage = \"room\"\n", "scene.toml", "");
    EXPECT_EQ(o.environment.image, "./room");
}

TEST(SceneFile, ColoursAreThoseOfTheCommandLine) {
    for (const std::string color : {"#8040c0", "#f08", "0.3", "2,0.5,0"}) {
        const std::string toml = color[0] == '#' ? "\"" + color + "\"" : "[" + color + "]";
        const std::string value = color == "0.3" ? color : toml;
        EXPECT_EQ(read("[render]\nambient = " + value).ambient, parse_color(color)) << color;
    }
}

TEST(SceneFile, IsEmptyWhereNothingIsSaid) {
    const SceneOptions o = read("");
    EXPECT_TRUE(o.objects.empty());
    EXPECT_EQ(scene_text(o, ""), "");
}

// ---- writing

/// A file that says something of each section, with random numbers.
std::string random_scene(raster::laws::Random& random) {
    const auto number = [&] { return std::to_string(random.real(0.01f, 1.0f)); };
    const auto three = [&] { return "[" + number() + ", " + number() + ", " + number() + "]"; };
    std::string text = "[camera]\n";
    text += random.one_in(2) ? "view = [" + number() + ", " + number() + "]\n"
                             : "eye = " + three() + "\nup = " + three() + "\n";
    text += random.one_in(2) ? "fov_deg = 2" + number() + "\n" : "lens_mm = 3" + number() + "\n";
    text += "[render]\nambient = " + three() + "\nbackground = \"none\"\nfloor = true\n";
    text += "crease_deg = " + number() + "\nfalloff_k = " + number() + "\nshadows = \"zpass\"\n";
    text += "shadow_map_size = 99\nshadow_pcf = 3\nshadow_bias = " + number() + "\n";
    text += "own_textures = false\n";
    text += "[surface]\nks = " + number() + "\nopacity_texture = \"t\"\n";
    text += "[environment]\nlight = true\n";
    text += random.one_in(2) ? "built_in = \"room\"\n" : "image = \"a.hdr\"\n";
    text += "[[texture]]\nname = \"t\"\nrepeat = [" + number() + ", 2]\nlow = " + three() + "\n";
    text += random.one_in(2) ? "pattern = \"wood\"\naxis = \"z\"\n" : "image = \"a.png\"\n";
    text += "[[material]]\nname = \"b\"\nroughness = " + number() + "\nopacity = " + number() +
            "\nbump_texture = \"t\"\nfresnel = \"fast\"\n";
    text += random.one_in(2) ? "metal = \"copper\"\n" : "reflectance = " + three() + "\n";
    text += "[[light]]\nposition = " + three() + "\nfalloff = \"inverse\"\ncolor = \"#123456\"\n";
    text += "[[light]]\ndirection = " + three() + "\n";
    text += "[[material]]\nname = \"a \\\"b\\\" \\\\ \\u00e9\"\nkd = " + three() +
            "\nn = " + number() + "\n";
    text += "[[object]]\nshape = \"cube\"\nmaterial = \"a \\\"b\\\" \\\\ \\u00e9\"\nscale = " +
            three() + "\ntranslate = " + three() + "\nrotate = [{axis = " + three() +
            ", deg = " + number() +
            "}, {axis = [0, 1, 0], deg = 5}]\nillumination = \"lambert\"\ncull = \"front\"\n"
            "diffuse_texture = \"t\"\n";
    return text;
}

TEST(SceneFile, WhatIsWrittenIsReadAgain) {
    raster::laws::Random random(7);
    for (int i = 0; i < 50; ++i) {
        std::string text = random_scene(random);
        text.erase(std::remove(text.begin(), text.end(), '\0'), text.end());
        const std::string written = scene_text(read(text), "folder");
        EXPECT_NE(written, "");
        EXPECT_EQ(scene_text(read(written), "folder"), written) << text;
    }
}

/// With as many corners as there may be: a saw's upper side, and its lower one.
std::string saw() {
    std::string text = "polygon:0,-1:32,-1";
    for (int i = 61; i >= 0; --i)
        text += ":" + std::to_string(i) + ".125," + std::to_string(i % 2) + ".0625";
    return text;
}

TEST(SceneFile, SavedSceneDrawsTheSamePicture) {
    const Shell shell;
    shell.run("mkdir deep");
    shell.write("t.obj", "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\n");
    const std::string lines[] = {
        "teapot:3 --shading gouraud --view 200,33 --light 1,1,1,#ff8040 --light "
        "point:0,2,0,inverse",
        "t.obj --floor --shadows zfail --light point:1,3,2 --material \"kd=0.1,0.7,0.3 n=7\"",
        "shape:torus:9,7 --eye 1,2,3 --lens 35 --background none --cull back --normals area",
        "cube --wireframe=over --projection orthographic --ambient 0.123456 --samples 4",
        "teapot:3 --texture \"diffuse=marble bend=2 low=#20242c high=#e8e4dc\" "
        "--texture \"bump=waves mapping=spherical count=9 height=0.1 repeat=2,1\"",
        "sphere:9,7 --illumination cook-torrance --metal copper --roughness 0.3 --distribution "
        "gauss",
        "sphere:9,7 --environment room --environment-light --material \"kd=0.1 mirror=0.7 "
        "opacity=0.6 tf=1,0.5,0.2\"",
        "sphere:9,7 --environment room --material \"kd=0.1 refract=0.7\" --ior 1.4",
        "sphere:9,7 --floor --environment-from 0,1,0.5 --material \"kd=0.1 mirror=0.7\"",
        "cube --floor --shadows map --shadow-map-size 64 --shadow-bias 2 --shadow-pcf 3",
        "torus:9,7 --illumination hall --material \"kdt=0.6 kt=0.2 nt=4\" --ior 1.2 --light "
        "0,0,-1",
        saw() + " --view 0,0",
    };
    for (const std::string& line : lines) {
        const std::string size = " -s 60x40 -q";
        ASSERT_EQ(
            shell.run("scanlight render " + line + size + " -o a.png --save-scene deep/s.toml")
                .status,
            0)
            << line;
        const Outcome again = shell.run("scanlight render deep/s.toml -q -o b.png");
        ASSERT_EQ(again.status, 0) << again.err << shell.read("deep/s.toml");
        EXPECT_EQ(shell.read("a.png"), shell.read("b.png")) << shell.read("deep/s.toml");
    }
}

// ---- by the program

TEST(SceneFile, CommandLineComesOverTheFile) {
    const Shell shell;
    shell.write("s.toml",
                "[camera]\neye = [1, 2, 5]\n[render]\nsize = [60, 40]\nshading = \"flat\"\n"
                "[[light]]\ndirection = [0, 1, 0]\n"
                "[[object]]\nshape = \"sphere:9,7\"\nshading = \"gouraud\"\ncull = \"back\"\n");
    shell.run(
        "scanlight render sphere:9,7 -o a.png -s 60x40 --view 10,20 --shading phong --cull back "
        "--light 1,1,1");
    shell.run("scanlight render s.toml -o b.png --view 10,20 --shading phong --light 1,1,1");
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
}

TEST(SceneFile, TexturesAndMetalsOfTheCommandLineComeOverTheFile) {
    const Shell shell;
    shell.write("s.toml",
                "[render]\nsize = [60, 40]\nillumination = \"cook-torrance\"\n"
                "[environment]\nimage = \"gone.hdr\"\n"
                "[[texture]]\nname = \"t\"\npattern = \"wood\"\n"
                "[[material]]\nname = \"m\"\nior = 2\nkd = 0.1\nroughness = 0.3\n"
                "[[object]]\nshape = \"sphere:9,7\"\nmaterial = \"m\"\ndiffuse_texture = \"t\"\n");
    const std::string over =
        " --environment room --metal gold --texture \"diffuse=checker mapping=spherical\"";
    shell.run(
        "scanlight render sphere:9,7 -o a.png -s 60x40 --illumination cook-torrance "
        "--roughness 0.3" +
        over);
    shell.run("scanlight render s.toml -o b.png" + over);
    ASSERT_NE(shell.read("a.png"), "");
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
}

TEST(SceneFile, StandardInputCanBeAScene) {
    const Shell shell;
    shell.write("s.toml", "[render]\nsize = [20, 10]\n[[object]]\nshape = \"cube\"\n");
    EXPECT_EQ(shell.run("scanlight render s.toml -o a.png").status, 0);
    EXPECT_EQ(shell.run("scanlight render scene:- -o b.png < s.toml").status, 0);
    EXPECT_EQ(shell.run("cp s.toml s.txt && scanlight render scene:s.txt -o c.png").status, 0);
    EXPECT_EQ(shell.read("a.png"), shell.read("b.png"));
    EXPECT_EQ(shell.read("a.png"), shell.read("c.png"));
}

TEST(SceneFile, IncludesAreMeantFromTheirOwnFolder) {
    const Shell shell;
    shell.run("mkdir -p parts/meshes");
    shell.write("parts/meshes/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    shell.write("parts/t.toml",
                "[render]\nsize = [99, 9]\n[camera]\neye = [0, 0, 5]\n"
                "[[object]]\nmesh = \"meshes/t.obj\"\nmaterial = \"m\"\n");
    shell.write("s.toml",
                "include = [\"parts/t.toml\"]\n[render]\nsize = [20, 10]\n[camera]\nview = [0, 0]\n"
                "[[material]]\nname = \"m\"\nkd = 0.5\n");
    EXPECT_EQ(shell.run("scanlight scene s.toml").out,
              "[camera]\nview = [0, 0]\n\n[render]\nsize = [20, 10]\n\n[[material]]\nname = "
              "\"m\"\nkd = 0.5\n\n"
              "[[object]]\nmesh = \"parts/meshes/t.obj\"\nmaterial = \"m\"\n");
}

TEST(SceneFile, MeshesAreLoadedOnceHoweverOftenPlaced) {
    const Shell shell;
    shell.write(
        "s.toml",
        "[[object]]\nshape = \"cube\"\n[[object]]\nshape = \"cube\"\ntranslate = [3, 0, 0]\n"
        "[[object]]\nshape = \"cone:9\"\n");
    const auto info = nlohmann::json::parse(shell.run("scanlight info s.toml --json").out);
    EXPECT_EQ(info["objects"], 3);
    EXPECT_EQ(info["meshes"].size(), 2u);
}

// ---- what may be said

TEST(SceneReference, IsThePageInTheDocumentation) {
    const std::string page = contents_of(SCANLIGHT_TESTS_DIR "/../docs/scene.md");
    EXPECT_EQ(page, scene_reference())
        << "build/release/bin/scanlight scene --reference > docs/scene.md";
}

TEST(SceneReference, ShowsASceneThatCanBeRead) {
    const std::string page = scene_reference();
    const std::size_t begin = page.find("```toml\n") + 8;
    EXPECT_EQ(read(page.substr(begin, page.find("```", begin) - begin)).objects.size(), 2u);
}

TEST(SceneSchema, ListsTheKeysOfTheReference) {
    const auto schema = nlohmann::json::parse(scene_schema());
    const std::string page = scene_reference();
    for (const auto& [name, section] : schema["properties"].items()) {
        if (name == "include") continue;
        const bool is_repeated = section["type"] == "array";
        const std::string heading = is_repeated ? "[[" + name + "]]" : "[" + name + "]";
        EXPECT_NE(page.find("\n## `" + heading + "`"), std::string::npos) << heading;
        const auto& table = is_repeated ? section["items"] : section;
        for (const auto& [key, value] : table["properties"].items()) {
            const std::string inner = "\n## `[[" + name + "." + key + "]]`";
            const std::string row = "| `" + key + "` |";
            const bool has_a_table =
                value.value("type", "") == "array" && value["items"].value("type", "") == "object";
            EXPECT_NE(page.find(has_a_table ? inner : row), std::string::npos) << key;
        }
    }
    EXPECT_EQ(schema["properties"]["camera"]["properties"]["fov_deg"]["maximum"], 170.0);
}

}  // namespace
}  // namespace scanlight::apps
