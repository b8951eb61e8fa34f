#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "apps/scanlight/color_format.h"
#include "apps/scanlight/commands.h"
#include "apps/scanlight/frame_pattern.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scanlight/picture.h"
#include "apps/scanlight/progress.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/camera_path.h"
#include "apps/scene/left_out.h"
#include "apps/scene/scene_setup.h"
#include "apps/scene/usage_error.h"
#include "raster/gif.h"
#include "raster/save_file.h"
#include "raster/save_image.h"

namespace scanlight::apps {

namespace {

constexpr int most_frames = 100000;

struct TurntableOptions {
    SceneOptions scene;
    Means means;
    Orbit orbit;
    std::string output;
    std::string format;
    int frames = 36;
    double frames_a_second = 25.0;
    bool quiet = false;
};

// ---- where frames go

/// Takes the frames one by one, in their order.
struct FrameSink {
    std::function<void(int number, const Picture&)> add;
    std::function<void()> finish = [] {};
};

raster::Alpha alpha_of(const TurntableOptions& options) {
    return options.scene.background ? raster::Alpha::dropped : raster::Alpha::kept;
}

void make_folder_of(const std::string& file) {
    const auto folder = std::filesystem::path(file).parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) throw UsageError(folder.string() + ": cannot be made a folder: " + error.message());
}

bool is_gif(const TurntableOptions& options) {
    return options.format == "gif" || (options.format.empty() && options.output.ends_with(".gif"));
}

FrameSink gif_sink(const TurntableOptions& options) {
    const int delay = std::max(2, static_cast<int>(100.0 / options.frames_a_second + 0.5));
    auto encoder = std::make_shared<raster::GifEncoder>(options.scene.size, delay);
    return {[encoder](int, const Picture& picture) {
                encoder->add(byte_image(picture, raster::Alpha::dropped));
            },
            [encoder, path = options.output] {
                make_folder_of(path);
                raster::save_file(path, encoder->finish());
            }};
}

raster::ImageFormat picture_format(const TurntableOptions& options) {
    return options.format.empty() ? color_format(options.output)
                                  : raster::image_format("." + options.format);
}

Samples samples_of(const TurntableOptions& options) {
    if (is_gif(options)) return Samples::bytes;
    return raster::holds_floats(picture_format(options)) ? Samples::floats : Samples::bytes;
}

/// Pictures one after the other on standard output, or each in a file of its own.
FrameSink picture_sink(const TurntableOptions& options) {
    const auto format = picture_format(options);
    const auto save = [=, alpha = alpha_of(options), samples = samples_of(options)](
                          const std::string& path, const Picture& picture) {
        raster::save_image(path, color_image(picture, samples, alpha), format);
    };
    if (options.output == "-") return {[=](int, const Picture& picture) { save("-", picture); }};
    const FramePattern pattern(options.output);
    make_folder_of(pattern.name(0));
    return {[=](int number, const Picture& picture) { save(pattern.name(number), picture); }};
}

// ---- checks, before the work

void check_output(const TurntableOptions& options) {
    if (!is_gif(options) && options.output != "-") FramePattern(options.output);
    const bool has_alpha = !is_gif(options) && raster::holds_alpha(picture_format(options));
    if (!options.scene.background && !has_alpha) {
        throw UsageError(options.output +
                         ": this format holds no alpha channel for --background none; PNG does");
    }
    if (options.scene.show == Show::stencil && samples_of(options) == Samples::floats)
        throw UsageError(options.output + ": a heat map is a picture of bytes");
}

// ---- frames

/// "[===                 ] drawing frame 4 of 16": the bar is what is done.
std::string counted(int frame, int frames) {
    constexpr std::size_t length = 20;
    const auto done = length * static_cast<std::size_t>(frame) / static_cast<std::size_t>(frames);
    return "[" + std::string(done, '=') + std::string(length - done, ' ') + "] drawing frame " +
           std::to_string(frame + 1) + " of " + std::to_string(frames);
}

void turntable(const TurntableOptions& options) {
    check(options.means);
    check_size(options.scene);
    check_output(options);
    wireframe_of(options.scene);
    check_camera_keys(options.scene);
    Progress progress(options.quiet ? Progress::When::never : Progress::When::on_terminal);
    progress.now("loading " + options.scene.input);
    const Models models = load_models(options.scene);
    for (const auto& warning : warnings_of(models))
        if (!options.quiet) std::fprintf(stderr, "scanlight: %s\n", warning.c_str());
    const render::Scene unseen = unseen_scene_of(models, options.scene);
    for (const auto& sentence : left_out(unseen, options.scene))
        if (!options.quiet) std::fprintf(stderr, "scanlight: %s\n", sentence.c_str());
    const CameraPath path(models, options.scene, options.orbit);
    const FrameSink sink = is_gif(options) ? gif_sink(options) : picture_sink(options);
    for (int frame = 0; frame < options.frames; ++frame) {
        progress.now(counted(frame, options.frames));
        const SceneOptions moment =
            path.at(static_cast<double>(frame) / static_cast<double>(options.frames));
        const render::Scene scene = seen(unseen, models, moment);
        sink.add(frame, draw_picture(scene, moment, options.means, {samples_of(options), false}));
    }
    progress.now("saving " + options.output);
    sink.finish();
    if (options.output != "-" && !options.quiet)
        std::fprintf(stderr, "%s: %d frames of %dx%d\n", options.output.c_str(), options.frames,
                     options.scene.size.width, options.scene.size.height);
}

// ---- options

CLI::Validator within(double low, double high) {
    return CLI::Validator(
        [=](const std::string& text) {
            const double number = parse_number(text, "value");
            return number >= low && number <= high ? "" : "'" + text + "' is out of range";
        },
        "");
}

void add_turntable_options(CLI::App& app, TurntableOptions& o) {
    const HelpHeading heading(app, "Turntable");
    app.add_option("-o,--output", o.output,
                   "frames/%04d.png (or .ppm, .pfm, .hdr), a .gif that repeats for ever, or - for\n"
                   "a stream of PPMs, which ffmpeg reads; folders are made. Frames count from 0")
        ->required()
        ->type_name("OUT");
    app.add_option("--format", o.format, "format, whatever OUT's ending")
        ->type_name("png|ppm|pfm|hdr|gif")
        ->check(CLI::IsMember({"png", "ppm", "pfm", "hdr", "gif"}).description(""));
    app.add_option("--frames", o.frames, "how many")
        ->type_name("N")
        ->check(CLI::Range(1, most_frames).description("from 1 to 100000"))
        ->capture_default_str();
    app.add_option(
           "--orbit-deg", o.orbit.angle_deg,
           "how far the camera goes round in all, counter-clockwise from above; frame i has\n"
           "gone i/N of it, so that 360 repeats without a halt")
        ->type_name("DEG")
        ->check(within(-36000.0, 36000.0))
        ->capture_default_str();
    app.add_option("--elevation-deg", o.orbit.elevation_deg,
                   "above the horizon, instead of --view's")
        ->type_name("DEG")
        ->check(within(-90.0, 90.0));
    app.add_option("--fps", o.frames_a_second,
                   "frames a second, of a GIF, in whole hundredths of a second; at most 50")
        ->check(within(0.1, 50.0))
        ->capture_default_str();
    app.add_flag("-q,--quiet", o.quiet, "no messages but errors");
}

}  // namespace

void add_turntable_command(CLI::App& program) {
    auto options = std::make_shared<TurntableOptions>();
    CLI::App* command = program.add_subcommand(
        "turntable", "Pictures all round a mesh or scene, as numbered files, a GIF or a stream");
    add_scene_options(*command, options->scene);
    add_canvas_options(*command, options->scene);
    add_turntable_options(*command, *options);
    add_means_options(*command, options->means);
    command->footer(
        "A scene file with [[camera.key]] says where the camera goes; it then needs no "
        "--orbit-deg.\n"
        "Examples:\n"
        "  scanlight turntable teapot -o teapot.gif --frames 24 --size 320x240 --samples 4\n"
        "  scanlight turntable bunny.obj -o frames/%04d.png --frames 100 --elevation-deg 10\n"
        "  scanlight turntable room.toml -o - | ffmpeg -f image2pipe -c:v ppm -i - room.mp4");
    command->callback([options] { turntable(*options); });
}

}  // namespace scanlight::apps
