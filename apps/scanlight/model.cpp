#include "apps/scanlight/model.h"

#include <filesystem>

#include "apps/scanlight/stopwatch.h"
#include "apps/scanlight/usage_error.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace scanlight::apps {

namespace {

constexpr std::string_view shape_prefix = "shape:";

mesh::PolygonSoup load_soup(const std::string& input) {
    if (input.starts_with(shape_prefix)) return mesh::shape(input.substr(shape_prefix.size()));
    std::error_code ignored;
    const auto status = std::filesystem::status(input, ignored);
    const bool is_file =
        input == "-" || (std::filesystem::exists(status) && !std::filesystem::is_directory(status));
    if (is_file) return mesh::load(input);
    if (mesh::is_shape(input)) return mesh::shape(input);
    throw UsageError(input + ": no such file, nor a built-in shape: " + shape_names());
}

}  // namespace

std::string shape_names() {
    std::string names;
    for (const auto& shape : mesh::list_shapes())
        names += (names.empty() ? "" : ", ") + shape.name;
    return names;
}

Model load_model(const std::string& input, const mesh::NormalRule& normals) {
    Model model;
    model.name = input;
    Stopwatch stopwatch;
    const mesh::PolygonSoup soup = load_soup(input);
    model.load_seconds = stopwatch.lap();
    auto [mesh, report] = mesh::build(soup, normals);
    model.build_seconds = stopwatch.lap();
    model.mesh = std::move(mesh);
    model.report = report;
    model.warnings = soup.warnings;
    return model;
}

}  // namespace scanlight::apps
