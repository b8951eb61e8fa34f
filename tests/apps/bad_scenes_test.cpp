#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "apps/scene/document.h"
#include "apps/scene/read_scene.h"
#include "mesh/file_error.h"
#include "tests/apps/shell.h"

namespace scanlight::apps {
namespace {

/// What is said of a scene file, after "scene.toml:".
std::string complaint(const std::string& text) {
    try {
        SceneOptions options;
        read_scene(options, text, "scene.toml", "");
    } catch (const mesh::FileError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("scene.toml:")) << message;
        return message.substr(11);
    }
    return "nothing";
}

struct BadScene {
    std::string text;
    std::string message;
};

const std::string color_words =
    "a colour: \"#rrggbb\" or \"#rgb\" in sRGB, or linear light: one grey number or [r, g, b], "
    "each from 0 to 1e+06";
const std::string point_words = "[x, y, z], numbers from -1e+30 to 1e+30";

// clang-format off
const std::vector<BadScene>& bad_scenes() {
    static const std::vector<BadScene> all{
        // names
        {"[lights]\n", "1:2: unknown key 'lights' in a scene file; did you mean 'light'?"},
        {"[[light]]\ndirection = [0, 0, 1]\ncolour = 1\n", "3:1: unknown key 'colour' in [[light]]; did you mean 'color'?"},
        {"[camera]\nfov = 30\n", "2:1: unknown key 'fov' in [camera]; did you mean 'fov_deg'?"},
        {"[render]\n\"si\\nze\" = 1\n", "2:1: unknown key 'si?ze' in [render]; did you mean 'size'?"},
        {"zoom = 2\n", "1:1: unknown key 'zoom' in a scene file; did you mean 'light'?"},
        {"[camera.zoom]\n", "1:1: 'zoom': expected a number from 0.001 to 1000, not a table"},
        // tables
        {"camera = 3\n", "1:10: 'camera': expected a table [camera], not 3"},
        {"[[camera]]\n", "1:1: 'camera': expected a table [camera], not an array of 1 value"},
        {"[light]\ndirection = [0, 0, 1]\n", "1:1: 'light': expected tables [[light]], not a table"},
        {"light = [1, 2]\n", "1:9: 'light': expected tables [[light]], not an array of 2 values"},
        {"object = \"teapot\"\n", "1:10: 'object': expected tables [[object]], not 'teapot'"},
        // types
        {"[camera]\nzoom = \"2\"\n", "2:8: 'zoom': expected a number from 0.001 to 1000, not '2'"},
        {"[camera]\nzoom = true\n", "2:8: 'zoom': expected a number from 0.001 to 1000, not true"},
        {"[camera]\nzoom = 1979-05-27\n", "2:8: 'zoom': expected a number from 0.001 to 1000, not a date or time"},
        {"[render]\nfloor = 1\n", "2:9: 'floor': expected true or false, not 1"},
        {"[render]\nshading = 3\n", "2:11: 'shading': expected \"flat\", \"gouraud\" or \"phong\", not 3"},
        {"[render]\nshading = \"Phong\"\n", "2:11: 'shading': expected \"flat\", \"gouraud\" or \"phong\", not 'Phong'"},
        {"[render]\nsize = \"640x480\"\n", "2:8: 'size': expected [width, height], whole numbers from 1 to 16384, not '640x480'"},
        {"[render]\nsize = [640]\n", "2:8: 'size': expected [width, height], whole numbers from 1 to 16384, not an array of 1 value"},
        {"[camera]\neye = [1, 2, \"3\"]\n", "2:7: 'eye': expected " + point_words + ", not an array of 3 values"},
        {"[[object]]\nmesh = 5\n", "2:8: 'mesh': expected the path of a mesh file (OBJ, PLY, OFF, STL), from the scene file's folder, not 5"},
        // ranges
        {"[camera]\nfov_deg = 0.5\n", "2:11: 'fov_deg': expected a number from 1 to 170, not 0.5"},
        {"[camera]\nfov_deg = nan\n", "2:11: 'fov_deg': expected a number from 1 to 170, not nan"},
        {"[camera]\nzoom = inf\n", "2:8: 'zoom': expected a number from 0.001 to 1000, not inf"},
        {"[camera]\nzoom = 9223372036854775807\n", "2:8: 'zoom': expected a number from 0.001 to 1000, not 9223372036854775807"},
        {"[camera]\nview = [0, 91]\n", "2:8: 'view': expected [azimuth, elevation] in degrees, the elevation from -90 to 90, not an array of 2 values"},
        {"[camera]\neye = [0, 0, 1e31]\n", "2:7: 'eye': expected " + point_words + ", not an array of 3 values"},
        {"[camera]\nup = [0, 0, 0]\n", "2:6: 'up': expected " + point_words + ", not all 0, not an array of 3 values"},
        {"[render]\nsize = [0, 480]\n", "2:8: 'size': expected [width, height], whole numbers from 1 to 16384, not an array of 2 values"},
        {"[render]\nsize = [640.5, 480]\n", "2:8: 'size': expected [width, height], whole numbers from 1 to 16384, not an array of 2 values"},
        {"[render]\nsamples = 9\n", "2:11: 'samples': expected 1, 4 or 16, not 9"},
        {"[render]\ncrease_deg = 181\n", "2:14: 'crease_deg': expected a number from 0 to 180, not 181"},
        {"[render]\nambient = -0.1\n", "2:11: 'ambient': expected " + color_words + ", not -0.1"},
        {"[render]\nambient = \"red\"\n", "2:11: 'ambient': expected " + color_words + ", not 'red'"},
        {"[render]\nambient = \"#12345\"\n", "2:11: 'ambient': expected " + color_words + ", not '#12345'"},
        {"[render]\nbackground = \"nothing\"\n", "2:14: 'background': expected \"none\" or " + color_words + ", not 'nothing'"},
        {"[[light]]\ndirection = [0, 0, 0]\n", "2:13: 'direction': expected " + point_words + ", not all 0, not an array of 3 values"},
        {"[[object]]\nshape = \"\"\n", "2:9: 'shape': expected a built-in shape, such as \"teapot\" or \"torus:48,24\", not ''"},
        {"[[object]]\nshape = \"cube\"\nscale = 1e7\n", "3:9: 'scale': expected a number or [x, y, z], from -1e+06 to 1e+06, not 1e+07"},
        {"[[object]]\nshape = \"cube\"\nrotate = { axis = [0, 0, 0], deg = 5 }\n", "3:10: 'rotate': expected { axis = [x, y, z], deg = ANGLE }, or up to 16 of them in an array, not a table"},
        {"[[object]]\nshape = \"cube\"\nrotate = [{ axis = [0, 1, 0] }]\n", "3:10: 'rotate': expected { axis = [x, y, z], deg = ANGLE }, or up to 16 of them in an array, not an array of 1 value"},
        {"[[object]]\nshape = \"cube\"\nmatrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]\n", "3:10: 'matrix': expected four rows of four numbers, the last row [0, 0, 0, 1], not an array of 4 values"},
        {"[[material]]\nname = \"a\"\nn = -1\n", "3:5: 'n': expected a number from 0 to 1e+30, not -1"},
        // what goes together
        {"[camera]\nview = [0, 0]\neye = [1, 2, 3]\n", "3:1: 'view' and 'eye' in one [camera]; expected one of them"},
        {"[camera]\nfov_deg = 30\nlens_mm = 50\n", "3:1: 'fov_deg' and 'lens_mm' in one [camera]; expected one of them"},
        {"[camera]\ntarget = [1, 2, 3]\n", "2:1: 'target' without 'eye' in [camera]"},
        {"[[light]]\ncolor = 1\n", "1:1: [[light]] without 'direction' or 'position'"},
        {"[[light]]\ndirection = [0, 0, 1]\nposition = [0, 0, 1]\n", "3:1: 'direction' and 'position' in one [[light]]; expected one of them"},
        {"[[light]]\ndirection = [0, 0, 1]\nfalloff = \"inverse\"\n", "3:1: 'falloff' without 'position' in [[light]]"},
        {"[[object]]\nscale = 2\n", "1:1: [[object]] without 'mesh' or 'shape'"},
        {"[[object]]\nmesh = \"a.obj\"\nshape = \"cube\"\n", "3:1: 'mesh' and 'shape' in one [[object]]; expected one of them"},
        {"[[material]]\nkd = 1\n", "1:1: [[material]] without 'name'"},
        {"[[material]]\nname = \"a\"\n[[material]]\nname = \"a\"\n", "4:8: a second material named 'a'"},
        {"[[material]]\nname = \"gold\"\n[[object]]\nshape = \"cube\"\nmaterial = \"glod\"\n", "5:12: no material is named 'glod'; did you mean 'gold'?"},
        {"[[object]]\nshape = \"cube\"\nmaterial = \"gold\"\n", "3:12: no material is named 'gold'"},
        // textures
        {"[[texture]]\npattern = \"wood\"\n", "1:1: [[texture]] without 'name'"},
        {"[[texture]]\nname = \"a\"\n", "1:1: [[texture]] without 'image' or 'pattern'"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\nimage = \"a.png\"\n", "3:1: 'image' and 'pattern' in one [[texture]]; expected one of them"},
        {"[[texture]]\nname = \"a\"\npattern = \"wod\"\n", "3:11: 'pattern': expected \"checker\", \"stripes\", \"gradient\", \"waves\", \"wood\", \"marble\" or \"cubes\", not 'wod'"},
        {"[[texture]]\nname = \"a\"\nimage = 3\n", "3:9: 'image': expected the path of a picture (PNG, JPEG, PPM, PGM, PFM, HDR), from the scene file's folder, not 3"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\nmapping = \"box\"\n", "4:11: 'mapping': expected \"uv\", \"planar\", \"cylindrical\", \"chapter-cylinder\" or \"spherical\", not 'box'"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\naxis = \"w\"\n", "4:8: 'axis': expected \"x\", \"y\" or \"z\", not 'w'"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\nrepeat = [1, 2, 3]\n", "4:10: 'repeat': expected a number or [u, v], from -10000 to 10000, not an array of 3 values"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\ncount = 0\n", "4:9: 'count': expected a number from 1 to 10000, not 0"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\nwrap = true\n", "4:8: 'wrap': expected \"repeat\", \"clamp\" or \"mirror\", not true"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\nhight = 1\n", "4:1: unknown key 'hight' in [[texture]]; did you mean 'high'?"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\n[[texture]]\nname = \"a\"\npattern = \"wood\"\n", "5:8: a second texture named 'a'"},
        {"[[texture]]\nname = \"a\"\npattern = \"wood\"\n[[object]]\nshape = \"cube\"\ndiffuse_texture = \"b\"\n", "6:19: no texture is named 'b'; did you mean 'a'?"},
        {"[[material]]\nname = \"m\"\nbump_texture = \"waves\"\n", "3:16: no texture is named 'waves'"},
        {"\n[surface]\nopacity_texture = \"net\"\n", "3:19: no texture is named 'net'"},
        {"[[object]]\nshape = \"cube\"\ndifuse_texture = \"a\"\n", "3:1: unknown key 'difuse_texture' in [[object]]; did you mean 'diffuse_texture'?"},
        {"[[object]]\nshape = \"cube\"\nnormal_texture = 1\n", "3:18: 'normal_texture': expected text of 1 to 200 bytes, not 1"},
        // surfaces
        {"[surface]\nopacity = 1.5\n", "2:11: 'opacity': expected a number from 0 to 1, not 1.5"},
        {"[surface]\nmirror = \"all\"\n", "2:10: 'mirror': expected " + color_words + ", not 'all'"},
        {"[surface]\nior = 0\n", "2:7: 'ior': expected a number from 0.1 to 100, not 0"},
        {"[surface]\nmetal = \"gold\"\nior = 1.5\n", "2:1: 'ior' and 'metal' in one [surface]; expected one of them"},
        {"[[material]]\nname = \"a\"\nreflectance = 0.5\nmetal = \"gold\"\n", "3:1: 'metal' and 'reflectance' in one [[material]]; expected one of them"},
        {"[surface]\nspecular_share = 2\n", "2:18: 'specular_share': expected a number from 0 to 1, not 2"},
        {"[surface]\ndistribution = \"beckman\"\n", "2:16: 'distribution': expected \"beckmann\", \"gauss\" or \"cosine\", not 'beckman'"},
        {"[surface]\nrougness = 0.2\n", "2:1: unknown key 'rougness' in [surface]; did you mean 'roughness'?"},
        // environment and shadows
        {"[environment]\nimage = \"a.hdr\"\nbuilt_in = \"room\"\n", "3:1: 'image' and 'built_in' in one [environment]; expected one of them"},
        {"[environment]\nbuilt_in = \"hall\"\n", "2:12: 'built_in': expected \"room\", not 'hall'"},
        {"[environment]\nlayout = \"dome\"\n", "2:10: 'layout': expected \"latitudes\", \"sphere\" or \"cube\", not 'dome'"},
        {"[environment]\nseen_from = [1, 2]\n", "2:13: 'seen_from': expected " + point_words + ", not an array of 2 values"},
        {"[environment]\nlight = 1\n", "2:9: 'light': expected true or false, not 1"},
        {"[render]\nshadow_map_size = 31\n", "2:19: 'shadow_map_size': expected a whole number from 32 to 8192, not 31"},
        {"[render]\nshadow_map_size = 64.5\n", "2:19: 'shadow_map_size': expected a whole number from 32 to 8192, not 64.5"},
        {"[render]\nshadow_pcf = 4\n", "2:14: 'shadow_pcf': expected an odd number from 1 to 15, not 4"},
        {"[render]\nshadow_bias = -1\n", "2:15: 'shadow_bias': expected a number from 0 to 1000, not -1"},
        {"[render]\nshadows = \"soft\"\n", "2:11: 'shadows': expected \"none\", \"zpass\", \"zpass-from-zero\", \"zfail\", \"map\" or \"polygons\", not 'soft'"},
        // includes
        {"include = \"a.toml\"\n", "1:11: 'include': expected an array of paths of scene files, not 'a.toml'"},
        {"include = [1]\n", "1:12: 'include': expected an array of paths of scene files, not 1"},
        {"include = [\"/no/such/file.toml\"]\n", "1:12: 'include': /no/such/file.toml: cannot be opened: No such file or directory"},
        {"include = [\"/dev/zero\"]\n", "1:12: 'include': /dev/zero: is a device, not a file or pipe"},
        {"include = [\"/\"]\n", "1:12: 'include': /: is a folder"},
    };
    return all;
}
// clang-format on

TEST(BadScenes, AreRefusedWithPlaceAndReason) {
    EXPECT_GE(bad_scenes().size(), 90u);
    for (const auto& [text, message] : bad_scenes())
        EXPECT_EQ(complaint(text), message) << text;
}

/// The parser's own words may change with its version; the place may not.
TEST(BadScenes, ThatAreNotTomlAreRefusedAtTheirPlace) {
    const std::pair<std::string, std::string> cases[] = {
        {"[camera\n", "1:"},
        {"\u00e9 = 1\n", "1:1:"},
        {"[camera]\nfov_deg = {\u0277xis = 1}\n", "2:12:"},
        {"[\neye = 1\n", "1:2: Error while parsing key: expected bare key starting character"},
        {"[camera]\nzoom = \n", "2:"},
        {"[camera]\nzoom = 1\nzoom = 2\n", "3:"},
        {"[camera]\n[camera]\n", "2:"},
        {"[render]\nambient = [1, 2\n", "2:"},
        {"a = \"\xff\"\n", "1:"},
        {std::string("a = \"\0\"\n", 8), "1:"},
        {"[[light]]\n[light]\n", "2:"},
    };
    for (const auto& [text, place] : cases) {
        const std::string message = complaint(text);
        EXPECT_TRUE(message.starts_with(place)) << text << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

std::string repeated(const std::string& text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

TEST(BadScenes, CannotNestThemselvesThroughTheStack) {
    for (const std::string open : {"[", "{a=", "[[", "{a=["}) {
        for (const int depth : {100, 20000}) {
            const std::string message = complaint("include = " + repeated(open, depth));
            EXPECT_TRUE(message.starts_with("1:")) << message;
        }
    }
    EXPECT_EQ(complaint("[" + repeated("a.", 300000) + "a]\n"),
              "1:1: more than 160 dots in a line");
    EXPECT_EQ(complaint("\n" + repeated("a.", 300000) + "a = 1\n"),
              "2:1: more than 160 dots in a line");
    EXPECT_EQ(complaint(repeated("#", 9) + repeated(".", 300) + "\n"), "nothing");
}

TEST(BadScenes, OfMoreThanOneMebibyteAreRefused) {
    const std::string message = complaint("# " + std::string(max_document_bytes, 'x'));
    EXPECT_EQ(message, " a scene file larger than 1 MiB");
}

TEST(BadScenes, NameTooMuchOfOneKind) {
    EXPECT_EQ(complaint(repeated("[[light]]\ndirection = [0, 0, 1]\n", 1001)),
              "2001:1: more than 1000 of [[light]]");
}

// ---- by the program

std::string complaint_of(const Shell& shell, const std::string& line) {
    const Outcome outcome = shell.run(line);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_TRUE(is_one_complaint(outcome.err)) << outcome.err;
    EXPECT_FALSE(shell.has("out.png")) << line;
    return outcome.err;
}

TEST(BadScenes, LeaveNoPictureBehind) {
    const Shell shell;
    shell.write("a.toml", "[camera]\nfov_deg = 200\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render a.toml -o out.png"),
              "scanlight: a.toml:2:11: 'fov_deg': expected a number from 1 to 170, not 200\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render scene:- -o out.png < a.toml"),
              "scanlight: standard input:2:11: 'fov_deg': expected a number from 1 to 170, not "
              "200\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render none.toml -o out.png"),
              "scanlight: none.toml: cannot be opened: No such file or directory\n");
}

TEST(BadScenes, OfMeshesThatAreNotThere) {
    const Shell shell;
    shell.write("a.toml", "\n[[object]]\nmesh = \"gone.obj\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render a.toml -o out.png"),
              "scanlight: a.toml:3:8: mesh 'gone.obj': no such file\n");
    shell.run("mkfifo pipe.obj");
    shell.write("b.toml", "[[object]]\nmesh = \"pipe.obj\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render b.toml -o out.png"),
              "scanlight: b.toml:2:8: mesh 'pipe.obj': no such file\n");
    shell.write("c.toml", "[[object]]\nshape = \"teapod\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render c.toml -o out.png"),
              "scanlight: c.toml:2:9: no shape is named 'teapod'; the nearest is 'teapot'\n");
    shell.write("bad.obj", "v 1 2 3\nf 1 2 3\n");
    shell.write("d.toml", "[[object]]\nmesh = \"bad.obj\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render d.toml -o out.png")
                  .find("scanlight: d.toml:2:8: bad.obj:2: "),
              0u);
}

TEST(BadScenes, OfPicturesThatAreNotThere) {
    const Shell shell;
    shell.write("a.toml",
                "[[object]]\nshape = \"cube\"\ndiffuse_texture = \"t\"\n"
                "[[texture]]\nname = \"t\"\nimage = \"gone.png\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render a.toml -o out.png"),
              "scanlight: a.toml:6:9: image 'gone.png': no such file\n");
    shell.run("mkfifo pipe.hdr");
    shell.write("b.toml", "[environment]\nimage = \"pipe.hdr\"\n[[object]]\nshape = \"cube\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render b.toml -o out.png"),
              "scanlight: b.toml:2:9: image 'pipe.hdr': no such file\n");
    shell.write("bad.png", "no picture");
    shell.write("c.toml", "[environment]\nimage = \"bad.png\"\n[[object]]\nshape = \"cube\"\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render c.toml -o out.png")
                  .find("scanlight: c.toml:2:9: bad.png: "),
              0u);
}

TEST(BadScenes, ThatIncludeThemselvesOrTooDeep) {
    const Shell shell;
    shell.write("a.toml", "include = [\"b.toml\"]\n");
    shell.write("b.toml", "include = [\"a.toml\"]\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render a.toml -o out.png"),
              "scanlight: b.toml:1:12: a.toml includes itself\n");
    for (int i = 0; i < 20; ++i)
        shell.write("n" + std::to_string(i) + ".toml",
                    "include = [\"n" + std::to_string(i + 1) + ".toml\"]\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render n0.toml -o out.png"),
              "scanlight: n15.toml:1:12: includes are nested more than 16 deep\n");
    // Each names the next twice: 2^12 readings.
    for (int i = 0; i < 12; ++i) {
        const std::string next = "\"m" + std::to_string(i + 1) + ".toml\"";
        shell.write("m" + std::to_string(i) + ".toml", "include = [" + next + ", " + next + "]\n");
    }
    shell.write("m12.toml", "");
    const std::string message = complaint_of(shell, "scanlight render m0.toml -o out.png");
    EXPECT_NE(message.find(": more than 256 includes\n"), std::string::npos) << message;
}

TEST(BadScenes, OfMoreFacesThanMemoryHolds) {
    const Shell shell;
    shell.write("a.toml", repeated("[[object]]\nshape = \"plane:1000\"\n", 20));
    EXPECT_EQ(complaint_of(shell, "scanlight render a.toml -o out.png"),
              "scanlight: a.toml:33:1: more than 16777216 faces in all\n");
}

TEST(BadScenes, PlacedBeyondWhatAFloatHolds) {
    const Shell shell;
    shell.write("far.obj", "v 1e35 0 0\nv 0 1e35 0\nv 0 0 1e35\nf 1 2 3\n");
    shell.write("a.toml", "[[object]]\nmesh = \"far.obj\"\nscale = 1e6\n");
    EXPECT_EQ(complaint_of(shell, "scanlight render a.toml -o out.png"),
              "scanlight: a.toml:1:1: the object is placed beyond what a float holds\n");
}

}  // namespace
}  // namespace scanlight::apps
