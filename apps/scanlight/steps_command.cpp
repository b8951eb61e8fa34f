#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/shadow_report.h"
#include "apps/scanlight/steps_report.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/usage_error.h"
#include "raster/save_file.h"
#include "render/steps.h"

namespace scanlight::apps {

namespace {

using render::PolygonSteps;
using Seen = std::vector<render::SeenPolygon>;

struct StepsOptions {
    SceneOptions scene;
    std::string output = "-";
    std::string polygon;  // a number, "all", or empty for the tallest
    int object = 1;       // of a scene file, in its order
    std::string pixel;    // X,Y: its shadows, instead of polygons
    bool json = false;
};

/// The one that crosses most scanlines; of several the first.
Seen tallest(const Seen& seen) {
    if (seen.size() <= 1) return seen;
    const auto found = std::ranges::max_element(seen, {}, &render::SeenPolygon::scanlines);
    std::fprintf(stderr,
                 "scanlight: %zu polygons are seen; this is %u, the tallest (see --polygon)\n",
                 seen.size(), found->id);
    return {*found};
}

Seen with_number(const Seen& seen, const std::string& text) {
    const double number = parse_number(text, "polygon");
    Seen found;
    std::ranges::copy_if(seen, std::back_inserter(found),
                         [number](const auto& polygon) { return polygon.id == number; });
    if (found.empty()) throw UsageError("polygon " + text + " is not seen, or not there at all");
    return found;
}

Seen chosen(const Seen& seen, const std::string& polygon) {
    if (polygon.empty()) return tallest(seen);
    return polygon == "all" ? seen : with_number(seen, polygon);
}

std::vector<PolygonSteps> trace(const render::Scene& scene, const SceneOptions& options,
                                const Seen& polygons) {
    auto traced = render::trace_polygons(scene, options.settings, options.size, polygons);
    for (auto& steps : traced)
        steps = with_grey_as_one(std::move(steps));
    return traced;
}

std::string title_of(const PolygonSteps& steps, const StepsOptions& options) {
    return "Polygon " + std::to_string(steps.id) + " of " + options.scene.input + ": " +
           std::to_string(steps.corners.size()) + " corners, " +
           std::to_string(options.scene.size.width) + "x" +
           std::to_string(options.scene.size.height) + " pixels";
}

std::string texts_of(const std::vector<PolygonSteps>& polygons, const StepsOptions& options) {
    std::string text;
    for (const auto& steps : polygons) {
        text += (text.empty() ? "" : "\n\n") + steps_text(steps, title_of(steps, options));
    }
    return text;
}

struct PixelPlace {
    int x, y;
};

PixelPlace parse_pixel(const std::string& text, raster::Viewport size) {
    PixelPlace pixel{};
    char end = 0;
    const int read = std::sscanf(text.c_str(), "%d,%d%c", &pixel.x, &pixel.y, &end);
    const bool is_inside =
        pixel.x >= 0 && pixel.x < size.width && pixel.y >= 0 && pixel.y < size.height;
    if (read != 2 || !is_inside) {
        throw UsageError("pixel '" + text + "': expected X,Y from 0,0 to " +
                         std::to_string(size.width - 1) + "," + std::to_string(size.height - 1));
    }
    return pixel;
}

/// Of each light.
std::vector<PixelShadow> shadows_at(const render::Scene& scene, const SceneOptions& options,
                                    const PixelPlace& pixel) {
    const auto drawing = render::draw_depth(scene, options.settings, options.size);
    const raster::Depth depth = drawing.framebuffer.depth.at(pixel.x, pixel.y);
    std::vector<PixelShadow> shadows;
    for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
        shadows.push_back(
            {pixel.x, pixel.y, i, depth,
             render::shadow_crossings(scene, options.settings, i, options.size, pixel.x, pixel.y)});
    }
    return shadows;
}

std::string pixel_report(const render::Scene& scene, const StepsOptions& options) {
    const auto pixel = parse_pixel(options.pixel, options.scene.size);
    const auto shadows = shadows_at(scene, options.scene, pixel);
    if (options.json) return shadows_json(shadows);
    std::string text;
    for (const PixelShadow& shadow : shadows)
        text += (text.empty() ? "" : "\n") + shadow_text(shadow);
    return text;
}

/// The chosen object comes first: its polygons are those that are told of.
render::Scene with_first(render::Scene scene, int object, std::size_t objects) {
    if (object < 1 || static_cast<std::size_t>(object) > objects) {
        throw UsageError("object " + std::to_string(object) + ": expected one of " +
                         std::to_string(objects));
    }
    std::swap(scene.objects.front(), scene.objects[static_cast<std::size_t>(object) - 1]);
    return scene;
}

void steps(const StepsOptions& options) {
    check_shadows(options.scene);
    if (!options.pixel.empty()) volumes_for("--pixel", options.scene);
    const Models models = load_models(options.scene);
    for (const auto& warning : warnings_of(models))
        std::fprintf(stderr, "scanlight: %s\n", warning.c_str());
    const render::Scene scene =
        with_first(scene_of(models, options.scene), options.object, options.scene.objects.size());
    if (!options.pixel.empty())
        return raster::save_file(options.output, pixel_report(scene, options));
    const Seen seen = render::seen_polygons(scene, options.scene.settings, options.scene.size);
    const auto polygons = trace(scene, options.scene, chosen(seen, options.polygon));
    const StepsSource source{options.scene, scene.camera, seen.size()};
    if (polygons.empty()) std::fprintf(stderr, "scanlight: no polygon is seen\n");
    raster::save_file(options.output,
                      options.json ? steps_json(source, polygons) : texts_of(polygons, options));
}

/// What suits a page: few pixels, one intensity that varies, the textbook's even interpolation.
void set_defaults(SceneOptions& scene) {
    scene.material = parse_material("kd=0.6 ks=0.4 n=8");
    scene.size = {24, 16};
    scene.settings.shading = render::Shading::gouraud;
    scene.settings.perspective = render::Perspective::affine;
}

}  // namespace

void add_steps_command(CLI::App& program) {
    auto options = std::make_shared<StepsOptions>();
    set_defaults(options->scene);
    CLI::App* command = program.add_subcommand(
        "steps", "The edge table and active edge table at work, scanline by scanline");
    add_scene_options(*command, options->scene);
    command
        ->add_option("--polygon", options->polygon,
                     "a polygon by its number in the file, or all; the tallest if not given")
        ->type_name("N|all");
    command
        ->add_option("--object", options->object,
                     "whose polygons, of a scene file's objects in their order")
        ->type_name("N")
        ->capture_default_str();
    command
        ->add_option(
            "--pixel", options->pixel,
            "instead of polygons, the faces of shadow volumes that this pixel's ray crosses,\n"
            "with the running counts of z-pass and z-fail")
        ->type_name("X,Y");
    command->add_flag("--floor", options->scene.floor,
                      "a white floor beneath the mesh, four times as wide");
    command->add_flag("--json", options->json, "as JSON, with a header that says what is shown");
    command->add_option("-o,--output", options->output, "file instead of standard output")
        ->type_name("OUT");
    command->footer(
        "x is where an edge crosses the centre line of a scanline, Δx its change to the next; I "
        "are\n"
        "intensities (--shading gouraud), N normals (--shading phong), with their increments down\n"
        "the edges and along the spans. Pixel i has its centre at i + 1/2.\n"
        "Examples:\n"
        "  scanlight steps shape:star --view 0,0\n"
        "  scanlight steps ngon:3 --view 10,30 --light point:0,0,2 --shading phong\n"
        "  scanlight steps polygon:0,1:-0.8,-0.8:0,-0.3:0.8,-0.8 --view 0,0\n"
        "  scanlight steps cube --polygon all --json -o cube.json\n"
        "  scanlight steps docs/scenes/still-life.toml --object 5 --shading flat\n"
        "  scanlight steps cube --floor --shadows zfail --pixel 5,14");
    command->callback([options] { steps(*options); });
}

}  // namespace scanlight::apps
