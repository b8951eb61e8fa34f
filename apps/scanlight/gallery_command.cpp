#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/figures.h"
#include "apps/scanlight/parse.h"
#include "apps/scanlight/progress.h"
#include "apps/scanlight/usage_error.h"
#include "raster/save_file.h"
#include "raster/save_image.h"

namespace scanlight::apps {

namespace {

struct GalleryOptions {
    std::string folder;
    std::string only;
    std::string panel_size = "400x300";
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

std::string figure_html(const Figure& figure) {
    std::string html = "<figure id=\"" + figure.name + "\">\n<img src=\"" + figure.name +
                       ".png\" alt=\"" + escaped(figure.caption) + "\">\n<figcaption>" +
                       escaped(figure.caption) + "\n<pre>";
    for (const auto& panel : figure.panels)
        html += "scanlight render " + escaped(panel) + "\n";
    return html + "</pre></figcaption>\n</figure>\n";
}

std::string page_html() {
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
        html += figure_html(figure);
    return html + "</html>\n";
}

void check_name(const std::string& name) {
    const auto has_name = [&name](const Figure& figure) { return figure.name == name; };
    if (name.empty() || std::ranges::any_of(figures(), has_name)) return;
    std::string names;
    for (const Figure& figure : figures())
        names += " " + figure.name;
    throw UsageError("no picture is named '" + name + "'; there are:" + names);
}

void gallery(const GalleryOptions& options) {
    check_name(options.only);
    const raster::Viewport size = parse_size(options.panel_size);
    const std::filesystem::path folder(options.folder);
    std::filesystem::create_directories(folder);
    Progress progress(Progress::When::on_terminal);
    for (const Figure& figure : figures()) {
        progress.now("drawing " + figure.name);
        if (!options.only.empty() && figure.name != options.only) continue;
        raster::save_image((folder / (figure.name + ".png")).string(), draw_figure(figure, size));
    }
    if (options.only.empty()) raster::save_file((folder / "index.html").string(), page_html());
}

}  // namespace

void add_gallery_command(CLI::App& program) {
    auto options = std::make_shared<GalleryOptions>();
    CLI::App* command =
        program.add_subcommand("gallery", "All pictures of the chapter so far, and a page of them");
    command->add_option("folder", options->folder, "where to write them")
        ->required()
        ->type_name("DIR");
    command->add_option("--only", options->only, "one picture by its name")->type_name("NAME");
    command->add_option("--panel", options->panel_size, "size of each panel")
        ->type_name("WxH")
        ->capture_default_str();
    command->footer(
        "Examples:\n  scanlight gallery pictures\n  scanlight gallery . --only shading");
    command->callback([options] { gallery(*options); });
}

}  // namespace scanlight::apps
