#include "apps/demo/program.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/demo/lesson.h"
#include "apps/demo/page.h"
#include "apps/demo/parse_and_act.h"
#include "apps/demo/report.h"
#include "apps/demo/settings.h"
#include "apps/demo/texts.h"
#include "apps/demo/walk.h"
#include "apps/scanlight/means.h"
#include "apps/scanlight/print_data.h"
#include "apps/scanlight/progress.h"
#include "apps/scene/parse.h"
#include "apps/scene/usage_error.h"
#include "raster/save_file.h"
#include "raster/save_image.h"

namespace scanlight::demo {

namespace {

struct Options {
    bool list = false;
    std::string lesson;
    std::vector<std::string> assignments;
    int frame = -1;  // -1: the first control where it starts
    std::string output;
    std::string folder;
    std::string language = "en";
    std::string size = "320x240";
    apps::Means means;
};

/// Throws UsageError where a step is asked for that the polygon has not.
void check_step(const Lesson& lesson, const Settings& settings, const Screen& screen) {
    if (!screen.walked) return;
    const auto last = static_cast<double>(walk_of(screen.walked->steps.trace).size()) - 1.0;
    const Settings start = starting_settings(lesson);
    for (const Control& control : lesson.controls) {
        if (control.moved != Moved::by_steps) continue;
        const double step = settings.at(control.name);
        if (step > last && step != start.at(control.name))
            throw apps::UsageError(control.name + " " + value_text(control, step) +
                                   ": this polygon has steps from 0 to " +
                                   value_text(control, last));
    }
}

void save_lesson(const Options& options) {
    const Language language = parse_language(options.language);
    const Lesson& lesson = lesson_named(options.lesson);
    Settings settings = starting_settings(lesson);
    for (const std::string& assignment : options.assignments)
        set(settings, lesson, assignment);
    if (options.frame >= 0) set_frame(settings, lesson, options.frame);
    const Screen screen = lesson.draw(settings, apps::parse_size(options.size), options.means);
    check_step(lesson, settings, screen);
    if (!options.output.empty())
        raster::save_image(options.output, picture_of(screen),
                           options.output == "-" ? raster::ImageFormat::png
                                                 : raster::image_format(options.output));
    if (options.output != "-") apps::print_data(lesson_text(lesson, settings, screen, language));
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw apps::UsageError(folder.string() + ": cannot be made a folder: " + error.message());
}

void export_course(const Options& options) {
    const PageOptions page{parse_language(options.language), apps::parse_size(options.size),
                           options.means};
    make_folder(options.folder);
    apps::Progress progress(apps::Progress::When::on_terminal);
    const std::string html = course_page(
        lessons(), page, [&](const std::string& lesson) { progress.now("drawing " + lesson); });
    const std::string path = (std::filesystem::path(options.folder) / "index.html").string();
    raster::save_file(path, html);
    std::fprintf(stderr, "%s: %zu lessons, %.1f MB\n", path.c_str(), lessons().size(),
                 static_cast<double>(html.size()) / 1e6);
}

void add_lesson_options(CLI::App& program, Options& options) {
    CLI::Option* lesson =
        program.add_option("--lesson", options.lesson, "draw a lesson and tell what it says")
            ->type_name("NAME");
    program
        .add_option("--set", options.assignments,
                    "where one of its controls stands, repeatable: a number, or a choice's word")
        ->type_name("CONTROL=VALUE")
        ->allow_extra_args(false)
        ->needs(lesson);
    program
        .add_option("--frame", options.frame,
                    "its first control at this stop, from 0; of the edge table this step")
        ->type_name("K")
        ->check(CLI::NonNegativeNumber)
        ->needs(lesson);
    program
        .add_option(
            "-o,--output", options.output,
            "picture of the lesson's panels side by side; - writes a PNG to standard output")
        ->type_name("PNG")
        ->needs(lesson);
}

void add_options(CLI::App& program, Options& options) {
    program.set_version_flag("--version", std::string("scanlight-demo ") + SCANLIGHT_VERSION);
    program.get_formatter()->column_width(30);
    program.add_flag("--list", options.list, "the lessons' names and titles");
    add_lesson_options(program, options);
    program
        .add_option("--export", options.folder,
                    "write the whole course into DIR/index.html: one page that needs no network")
        ->type_name("DIR");
    program
        .add_option("--language", options.language, "en or zh; a page has both, and begins in it")
        ->type_name("en|zh")
        ->capture_default_str();
    program.add_option("-s,--size", options.size, "size of each panel")
        ->type_name("WxH")
        ->capture_default_str();
    apps::add_means_options(program, options.means);
    program.footer(
        "Without any of these the window opens: scanlight-demo [IN] [OPTIONS]. IN is a mesh, a\n"
        "built-in shape or a scene file; without it the teapot is seen. The window's options are\n"
        "those of scanlight render that say what is seen, and of its own:\n"
        "  --snapshot PNG              save a picture of the window, and end\n"
        "  --measure FRAMES            turn the picture, print how long the frames took, and end\n"
        "  --controls                  print where each control of the window stands, and end\n"
        "Examples:\n"
        "  scanlight-demo bunny.obj --shadows zfail\n"
        "  scanlight-demo --list\n"
        "  scanlight-demo --window --lesson lost-highlight\n"
        "  scanlight-demo --lesson lost-highlight --set level=3 -o lost.png\n"
        "  scanlight-demo --lesson edge-table --frame 120 -o step.png\n"
        "  scanlight-demo --lesson mach-bands --language zh -o - | display\n"
        "  scanlight-demo --export course");
}

/// What the options ask for; without any, the help.
void act(const CLI::App& program, const Options& options) {
    apps::check(options.means);
    if (!options.folder.empty()) return export_course(options);
    if (!options.lesson.empty()) return save_lesson(options);
    apps::print_data(options.list ? list_text(parse_language(options.language)) : program.help());
}

}  // namespace

int run(int argc, const char* const* argv) {
    CLI::App program("Scanlight live, and its course: lessons drawn by the engine itself.",
                     "scanlight-demo");
    Options options;
    add_options(program, options);
    return parse_and_act(program, argc, argv, [&] {
        act(program, options);
        return exit_ok;
    });
}

}  // namespace scanlight::demo
