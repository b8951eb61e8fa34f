#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/scanlight/commands.h"
#include "raster/compare.h"
#include "raster/load_image.h"
#include "raster/save_image.h"

namespace scanlight::apps {

namespace {

using Json = nlohmann::ordered_json;

struct DiffOptions {
    std::string first;
    std::string second;
    std::string output;
    bool json = false;
};

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
                         {"first", d.worst->first},
                         {"second", d.worst->second}};
    }
    return json;
}

void print(const raster::Difference& d, std::FILE* to) {
    std::fprintf(to, "different  %lld of %lld pixels\n", static_cast<long long>(d.different_pixels),
                 static_cast<long long>(d.pixels));
    std::fprintf(to, "mean       %.6g of %g\n", d.mean_absolute, d.peak);
    std::fprintf(to, "rms        %.6g\n", d.root_mean_square);
    std::fprintf(to, "psnr       %.4g dB\n", raster::psnr_db(d));
    if (d.worst) {
        std::fprintf(to, "worst      %g and %g at pixel (%d, %d), channel %d\n", d.worst->first,
                     d.worst->second, d.worst->x, d.worst->y, d.worst->channel);
    }
}

void diff(const DiffOptions& options) {
    if (!options.output.empty()) raster::image_format(options.output);
    const raster::AnyImage first = raster::load_image(options.first);
    const raster::AnyImage second = raster::load_image(options.second);
    const raster::Difference difference = raster::compare(first, second);
    std::FILE* to = options.output == "-" ? stderr : stdout;  // a picture keeps a pipe to itself
    if (options.json) {
        std::fprintf(to, "%s\n", json_of(difference).dump(2).c_str());
    } else {
        print(difference, to);
    }
    if (!options.output.empty()) {
        raster::save_image(options.output, raster::difference_image(first, second));
    }
    if (difference.different_pixels > 0) throw Dissimilar();
}

}  // namespace

void add_diff_command(CLI::App& program) {
    auto options = std::make_shared<DiffOptions>();
    CLI::App* command = program.add_subcommand("diff", "How two pictures differ, pixel by pixel");
    command->add_option("first", options->first, "PNG, PPM, PFM or HDR; - reads standard input")
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
