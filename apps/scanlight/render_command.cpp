#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "apps/scanlight/color_format.h"
#include "apps/scanlight/commands.h"
#include "apps/scanlight/heat_map.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scanlight/picture.h"
#include "apps/scanlight/print_data.h"
#include "apps/scanlight/progress.h"
#include "apps/scanlight/statistics.h"
#include "apps/scene/left_out.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/stopwatch.h"
#include "apps/scene/usage_error.h"
#include "apps/scene/write_scene.h"
#include "raster/save_file.h"
#include "raster/save_image.h"
#include "render/draw.h"

namespace scanlight::apps {

namespace {

enum class Aov { depth, normal, id, stencil };

struct AovOption {
    Aov kind;
    std::string path;
};

struct RenderOptions {
    SceneOptions scene;
    Means means;
    std::string output;
    std::string format;
    std::vector<AovOption> aovs;
    std::string statistics;
    std::string saved_scene;
    bool quiet = false;
};

// ---- options

AovOption parse_aov(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    const std::string path = colon == std::string::npos ? "" : text.substr(colon + 1);
    const std::pair<std::string, Aov> kinds[] = {
        {"depth", Aov::depth}, {"normal", Aov::normal}, {"id", Aov::id}, {"stencil", Aov::stencil}};
    for (const auto& [name, aov] : kinds) {
        if (kind == name && !path.empty()) return {aov, path};
    }
    throw UsageError("aov '" + text +
                     "': expected depth:PATH, normal:PATH, id:PATH or stencil:PATH");
}

/// One of a list of words. The option's type lists them already.
CLI::Validator one_of(const std::vector<std::string>& words) {
    return CLI::IsMember(words).description("");
}

void add_output_options(CLI::App& app, RenderOptions& options) {
    const HelpHeading heading(app, "Output");
    app.add_option("output,-o,--output", options.output,
                   "picture: .png, .ppm, .pfm or .hdr; - writes a PPM to standard output.\n"
                   "IN's name with .png if not given")
        ->type_name("OUT");
    app.add_option("--format", options.format, "format, whatever OUT's ending")
        ->type_name("png|ppm|pfm|hdr")
        ->check(one_of({"png", "ppm", "pfm", "hdr"}));
    app.add_option_function<std::vector<std::string>>(
           "--aov",
           [&options](const std::vector<std::string>& texts) {
               for (const auto& text : texts)
                   options.aovs.push_back(parse_aov(text));
           },
           "another picture, of the pixels' centres whatever --samples, repeatable: depth\n"
           "(16-bit PNG, or distance in PFM), normal (colours, or PFM),\n"
           "id (polygon number in 24 bits, or PFM), stencil (in how many shadow volumes the\n"
           "surface lies, as a heat map, or PFM)")
        ->type_name("depth|normal|id|stencil:PATH")
        ->allow_extra_args(false);
    app.add_option(
           "--stats", options.statistics,
           "counts and times, on standard output, or on standard error if a picture goes there")
        ->type_name("json|text")
        ->check(one_of({"json", "text"}));
    app.add_option("--save-scene", options.saved_scene,
                   "a scene file (TOML) that draws this picture, with all options in it; - is\n"
                   "standard output")
        ->type_name("PATH");
    app.add_flag("-q,--quiet", options.quiet, "no messages but errors");
}

// ---- output

std::string default_output(const std::string& input) {
    const bool has_prefix = input.starts_with("shape:") || input.starts_with("scene:");
    const std::string name = input.substr(has_prefix ? 6 : 0);
    if (name == "-") return "scanlight.png";
    const std::string whole = std::filesystem::path(name).stem().string();
    const std::string stem = whole.substr(0, whole.find(':'));  // "torus:48,24" is a torus
    return (stem.empty() ? "scanlight" : stem) + ".png";
}

raster::ImageFormat format_of(const RenderOptions& options) {
    return options.format.empty() ? color_format(options.output)
                                  : raster::image_format("." + options.format);
}

raster::ImageFormat format_of(const AovOption& aov) {
    if (aov.kind == Aov::depth) return raster::image_format(aov.path);
    const auto format = color_format(aov.path);
    if (format == raster::ImageFormat::hdr) {
        throw UsageError(aov.path +
                         ": HDR keeps 8 bits of a number and none below zero, too "
                         "little for normals and ids; PFM keeps all");
    }
    return format;
}

Samples samples_of(raster::ImageFormat format) {
    return raster::holds_floats(format) ? Samples::floats : Samples::bytes;
}

/// No more than what is written in the end.
Wanted wanted(const RenderOptions& options) {
    const bool depth =
        std::ranges::find(options.aovs, Aov::depth, &AovOption::kind) != options.aovs.end();
    return {samples_of(format_of(options)), depth};
}

void save_color(const Picture& picture, const RenderOptions& options) {
    const auto format = format_of(options);
    const auto alpha = options.scene.background ? raster::Alpha::dropped : raster::Alpha::kept;
    raster::save_image(options.output, color_image(picture, samples_of(format), alpha), format);
}

raster::AnyImage depth_image(const Picture& picture, Samples samples,
                             const render::Camera& camera) {
    if (samples == Samples::bytes) return raster::depth_image(*picture.depth);
    return float_image(render::eye_distances(*picture.depth, camera));
}

raster::AnyImage normal_image(const render::Scene& scene, const SceneOptions& options,
                              Samples samples) {
    const auto normals = render::draw_normals(scene, options.settings, options.size);
    if (samples == Samples::bytes) return normals_image(normals);
    return normals_float_image(normals);
}

raster::AnyImage id_image(const render::Scene& scene, const SceneOptions& options,
                          Samples samples) {
    const auto ids = render::draw_ids(scene, options.settings, options.size);
    if (samples == Samples::bytes) return ids_image(ids);
    return ids_float_image(ids);
}

raster::AnyImage stencil_image(const render::Scene& scene, const SceneOptions& options,
                               Samples samples) {
    const auto counts = draw_stencil(scene, options);
    if (samples == Samples::bytes) return heat_map(counts);
    return counts_float_image(counts);
}

raster::AnyImage aov_image(Aov kind, Samples samples, const render::Scene& scene,
                           const SceneOptions& options, const Picture& picture) {
    switch (kind) {
        case Aov::depth:
            return depth_image(picture, samples, scene.camera);
        case Aov::normal:
            return normal_image(scene, options, samples);
        case Aov::id:
            return id_image(scene, options, samples);
        case Aov::stencil:
            return stencil_image(scene, options, samples);
    }
    return {};
}

void save_aov(const AovOption& aov, const render::Scene& scene, const SceneOptions& options,
              const Picture& picture) {
    const auto format = format_of(aov);
    raster::save_image(aov.path, aov_image(aov.kind, samples_of(format), scene, options, picture),
                       format);
}

void check_format(const RenderOptions& options) {
    const auto format = format_of(options);
    if (options.scene.show == Show::stencil && raster::holds_floats(format)) {
        throw UsageError(options.output +
                         ": a heat map is a picture of bytes; the counts as floats are --aov "
                         "stencil:PATH.pfm");
    }
    if (options.scene.background || raster::holds_alpha(format)) return;
    throw UsageError(options.output +
                     ": this format holds no alpha channel for --background none; PNG does, as "
                     "with --format png");
}

/// What is wrong with an output's name is said before the work, not after.
void check_outputs(RenderOptions& options) {
    if (options.output.empty()) options.output = default_output(options.scene.input);
    check_format(options);
    wireframe_of(options.scene);
    check_shadows(options.scene);
    std::set<std::string> paths{options.output};
    for (const auto& aov : options.aovs) {
        format_of(aov);
        if (aov.kind == Aov::stencil) volumes_for("--aov stencil", options.scene);
        if (!paths.insert(aov.path).second)
            throw UsageError(aov.path + ": two pictures of one name");
    }
    if (!options.saved_scene.empty() && !paths.insert(options.saved_scene).second)
        throw UsageError(options.saved_scene + ": a picture and a scene of one name");
    check_size(options.scene);
}

void save_scene(const RenderOptions& options) {
    if (options.saved_scene.empty()) return;
    const auto folder = std::filesystem::path(options.saved_scene).parent_path().generic_string();
    raster::save_file(options.saved_scene, scene_text(options.scene, folder));
}

bool uses_standard_output(const RenderOptions& options) {
    const auto is_pipe = [](const AovOption& aov) { return aov.path == "-"; };
    return options.output == "-" || options.saved_scene == "-" ||
           std::ranges::any_of(options.aovs, is_pipe);
}

void say(const RenderOptions& options, const std::string& message) {
    if (!options.quiet) std::fprintf(stderr, "%s\n", message.c_str());
}

void render(RenderOptions& options) {
    check(options.means);
    check_outputs(options);
    Progress progress(options.quiet ? Progress::When::never : Progress::When::on_terminal);
    progress.now("loading " + options.scene.input);
    const Models models = load_models(options.scene);
    for (const auto& warning : warnings_of(models))
        say(options, "scanlight: " + warning);
    const render::Scene scene = scene_of(models, options.scene);
    for (const auto& sentence : left_out(scene, options.scene))
        say(options, "scanlight: " + sentence);

    Stopwatch stopwatch;
    progress.now("drawing " + options.scene.input);
    const Picture picture = draw_picture(scene, options.scene, options.means, wanted(options));
    const double draw_seconds = stopwatch.lap();
    progress.now("saving " + options.output);
    save_color(picture, options);
    for (const auto& aov : options.aovs)
        save_aov(aov, scene, options.scene, picture);
    save_scene(options);
    const Statistics statistics{models, options.scene, picture.report, draw_seconds,
                                stopwatch.lap()};
    if (!options.statistics.empty()) {
        const std::string text =
            options.statistics == "json" ? as_json(statistics) : as_text(statistics);
        print_data(text, uses_standard_output(options) ? "-" : options.output);
    }
    if (options.output != "-") say(options, summary(options.output, statistics));
}

}  // namespace

void add_render_command(CLI::App& program) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        program.add_subcommand("render", "A mesh or scene file into a shaded picture");
    add_scene_options(*command, options->scene);
    add_canvas_options(*command, options->scene);
    add_output_options(*command, *options);
    add_means_options(*command, options->means);
    command->footer(
        "Built-in shapes: " + shape_names() +
        " (see scanlight shapes).\n"
        "Examples:\n"
        "  scanlight render teapot -o teapot.png --shading gouraud\n"
        "  scanlight render bunny.obj -o bunny.png --view 200,15 --material \"kd=#c8b090 ks=0.2 "
        "n=20\"\n"
        "  scanlight render sphere:16,8 -o s.png --light 1,1,1,#ff8040 --light -1,0.5,1,#4080ff\n"
        "  scanlight render teapot -o t.png --floor --shadows map --shadow-map-size 2048 "
        "--shadow-pcf "
        "5\n"
        "  scanlight render teapot -o t.png --floor --shadows polygons --show details\n"
        "  scanlight render teapot -o t.png --illumination cook-torrance --metal gold --roughness "
        "0.3\n"
        "  scanlight render sphere -o s.png --illumination hall --material \"kdt=0.6\" --light "
        "0,0,-1\n"
        "  scanlight render room.toml -o room.png --samples 16 --size 1920x1080\n"
        "  scanlight render part.stl -o - --background none --format png > part.png\n"
        "  scanlight render cow.obj -o cow.png --aov depth:z.png --aov normal:n.pfm --stats json");
    command->callback([options] { render(*options); });
}

}  // namespace scanlight::apps
