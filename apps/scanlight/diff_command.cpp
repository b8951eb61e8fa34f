#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "apps/scanlight/color_format.h"
#include "apps/scanlight/commands.h"
#include "apps/scanlight/print_data.h"
#include "apps/scene/json.h"
#include "raster/compare.h"
#include "raster/load_image.h"
#include "raster/save_image.h"

namespace scanlight::apps {

namespace {

struct DiffOptions {
    std::string first;
    std::string second;
    std::string output;
    bool json = false;
};

/// Samples are bytes, 16-bit words or floats, and a float holds each of them.
Json sample_json(double sample) {
    return json_number(static_cast<float>(sample));
}

Json json_of(const raster::Difference& d) {
    const double psnr = raster::psnr_db(d);
    Json json{{"pixels", d.pixels},
              {"different", d.different_pixels},
              {"mean", d.mean_absolute},
              {"rms", d.root_mean_square},
              {"psnr_db", std::isfinite(psnr) ? Json(psnr) : Json("infinite")},
              {"worst", nullptr}};
    if (d.worst) {
        json["worst"] = {{"x", d.worst->x},
                         {"y", d.worst->y},
                         {"channel", d.worst->channel},
                         {"first", sample_json(d.worst->first)},
                         {"second", sample_json(d.worst->second)}};
    }
    return json;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string lines_of(const raster::Difference& d) {
    std::string text = "different  " + std::to_string(d.different_pixels) + " of " +
                       std::to_string(d.pixels) + " pixels\nmean       " + number(d.mean_absolute) +
                       " of " + number(d.peak) + "\nrms        " + number(d.root_mean_square) +
                       "\npsnr       " + number(raster::psnr_db(d)) + " dB\n";
    if (d.worst) {
        text += "worst      " + number(d.worst->first) + " and " + number(d.worst->second) +
                " at pixel (" + std::to_string(d.worst->x) + ", " + std::to_string(d.worst->y) +
                "), channel " + std::to_string(d.worst->channel) + "\n";
    }
    return text;
}

void diff(const DiffOptions& options) {
    if (!options.output.empty()) color_format(options.output);
    const raster::AnyImage first = raster::load_image(options.first);
    const raster::AnyImage second = raster::load_image(options.second);
    const raster::Difference difference = raster::compare(first, second);
    print_data(options.json ? json_text(json_of(difference)) : lines_of(difference),
               options.output);
    if (!options.output.empty()) {
        raster::save_image(options.output, raster::difference_image(first, second));
    }
    if (difference.different_pixels > 0) throw Dissimilar();
}

}  // namespace

void add_diff_command(CLI::App& program) {
    auto options = std::make_shared<DiffOptions>();
    CLI::App* command = program.add_subcommand("diff", "How two pictures differ, pixel by pixel");
    command
        ->add_option("first", options->first, "PNG, JPEG, PPM, PFM or HDR; - reads standard input")
        ->required()
        ->type_name("A");
    command->add_option("second", options->second, "the picture to hold against it")
        ->required()
        ->type_name("B");
    command
        ->add_option("-o,--output", options->output, "difference picture: the brighter, the larger")
        ->type_name("OUT");
    command->add_flag("--json", options->json, "as JSON");
    command->footer(
        "Exit status: 0 the same pixels, 1 they differ, 2 an error (another size is one).\n"
        "Examples:\n"
        "  scanlight diff expected.png actual.png -o difference.png");
    command->callback([options] { diff(*options); });
}

}  // namespace scanlight::apps
