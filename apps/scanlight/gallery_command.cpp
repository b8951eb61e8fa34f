#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/figures.h"
#include "apps/scanlight/progress.h"
#include "apps/scene/parse.h"
#include "apps/scene/usage_error.h"
#include "raster/save_file.h"
#include "raster/save_image.h"

namespace scanlight::apps {

namespace {

struct GalleryOptions {
    std::string folder;
    std::string only;
    raster::Viewport panel_size{400, 300};
};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else {
            result += c;
        }
    }
    return result;
}

std::string size_text(raster::Viewport size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

std::string figure_html(const Figure& figure, raster::Viewport panel_size) {
    std::string html = "<figure id=\"" + figure.name + "\">\n<img src=\"" + figure.name +
                       ".png\" alt=\"" + escaped(figure.caption) + "\">\n<figcaption>" +
                       escaped(figure.caption) + "\n<pre>";
    for (const auto& panel : figure.panels)
        html += "scanlight render " + escaped(panel) + " --size " + size_text(panel_size) + "\n";
    return html + "</pre></figcaption>\n</figure>\n";
}

std::string page_html(raster::Viewport panel_size) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>Scanlight "
        "gallery</title>\n"
        "<style>body{font:16px/1.5 system-ui,sans-serif;max-width:1240px;margin:2rem auto;"
        "padding:0 1rem;color-scheme:light dark}figure{margin:0 0 3rem}img{max-width:100%}"
        "pre{white-space:pre-wrap;font-size:13px;opacity:.8}</style>\n"
        "<h1>Scanlight gallery</h1>\n"
        "<p>Each picture is drawn by the commands below it, one a panel.</p>\n";
    for (const Figure& figure : figures())
        html += figure_html(figure, panel_size);
    return html + "</html>\n";
}

/// The figures of one name, or all. Throws UsageError for a name that none has.
std::vector<Figure> chosen(const std::string& name) {
    if (name.empty()) return figures();
    const auto found = std::ranges::find(figures(), name, &Figure::name);
    if (found != figures().end()) return {*found};
    std::string names;
    for (const Figure& figure : figures())
        names += " " + figure.name;
    throw UsageError("no figure is named '" + name + "'; there are:" + names);
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) return;
    throw UsageError(folder.string() + ": cannot be made a folder: " + error.message());
}

std::string path_in(const std::filesystem::path& folder, const std::string& name) {
    return (folder / name).string();
}

void save_figures(const GalleryOptions& options, const std::vector<Figure>& which) {
    Progress progress(Progress::When::on_terminal);
    for (const Figure& figure : which) {
        progress.now("drawing " + figure.name);
        raster::save_image(path_in(options.folder, figure.name + ".png"),
                           draw_figure(figure, options.panel_size));
    }
}

void gallery(const GalleryOptions& options) {
    const std::vector<Figure> which = chosen(options.only);
    make_folder(options.folder);
    save_figures(options, which);
    std::string to_see = path_in(options.folder, which.front().name + ".png");
    if (options.only.empty()) {
        to_see = path_in(options.folder, "index.html");
        raster::save_file(to_see, page_html(options.panel_size));
    }
    std::fprintf(stderr, "%s: %zu figure%s written\n", to_see.c_str(), which.size(),
                 which.size() == 1 ? "" : "s");
}

}  // namespace

void add_gallery_command(CLI::App& program) {
    auto options = std::make_shared<GalleryOptions>();
    CLI::App* command =
        program.add_subcommand("gallery", "All pictures of the chapter so far, and a page of them");
    command->add_option("folder", options->folder, "where to write them")
        ->required()
        ->type_name("DIR");
    command->add_option("--only", options->only, "one figure by its name, without the page")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--panel",
            [options](const std::string& text) { options->panel_size = parse_size(text); },
            "size of each panel")
        ->type_name("WxH")
        ->default_str(size_text(options->panel_size));
    command->footer(
        "Examples:\n  scanlight gallery pictures\n  scanlight gallery . --only shading");
    command->callback([options] { gallery(*options); });
}

}  // namespace scanlight::apps
