#include "apps/scene/model.h"

#include <algorithm>
#include <filesystem>

#include "apps/scene/stopwatch.h"
#include "apps/scene/usage_error.h"
#include "mesh/bounds.h"
#include "mesh/load.h"
#include "mesh/shapes.h"

namespace scanlight::apps {

namespace {

constexpr std::string_view shape_prefix = "shape:";

bool is_file(const std::string& input) {
    std::error_code ignored;
    const auto status = std::filesystem::status(input, ignored);
    return input == "-" ||
           (std::filesystem::exists(status) && !std::filesystem::is_directory(status));
}

mesh::PolygonSoup load_soup(const std::string& input) {
    if (input.starts_with(shape_prefix)) return mesh::shape(input.substr(shape_prefix.size()));
    if (is_file(input)) return mesh::load(input);
    if (mesh::is_shape(input)) return mesh::shape(input);
    throw UsageError(input + ": no such file, nor a built-in shape: " + shape_names());
}

/// "no normals", or "no normals for 2 of 9 corners"; empty if every corner has its normal.
std::string normals_missing(const mesh::PolygonSoup& soup) {
    using Corner = mesh::PolygonSoup::Corner;
    const auto total = static_cast<std::ptrdiff_t>(soup.corners.size());
    const auto missing = std::ranges::count(soup.corners, mesh::PolygonSoup::none, &Corner::normal);
    if (missing == 0) return "";
    if (missing == total) return "no normals";
    return "no normals for " + std::to_string(missing) + " of " + std::to_string(total) +
           " corners";
}

void warn_of_normals(Model& model, const mesh::PolygonSoup& soup, const mesh::NormalRule& rule) {
    const std::string missing = normals_missing(soup);
    if (rule.weight != mesh::NormalWeight::file || missing.empty()) return;
    model.warnings.push_back(model.name + ": brings " + missing +
                             "; the mean of the faces' normals is taken instead");
}

/// Of the square -1 to 1: to the mesh's place and size.
void lay_beneath(mesh::PolygonSoup& square, const mesh::Box& box) {
    const glm::dvec3 size = box.high - box.low;
    const double half = 2.0 * std::max({size.x, size.y, size.z});
    for (glm::vec3& point : square.positions) {
        point = glm::vec3(glm::dvec3(box.center().x, box.low.y, box.center().z) +
                          half * glm::dvec3(point));
    }
}

}  // namespace

mesh::Mesh floor_beneath(const mesh::Box& box) {
    mesh::PolygonSoup square = mesh::shape("plane:16");
    lay_beneath(square, box);
    return mesh::build(square, {}).mesh;
}

bool names_shape(const std::string& input) {
    return input.starts_with(shape_prefix) || (!is_file(input) && mesh::is_shape(input));
}

std::vector<std::string> warnings_of(const Model& model) {
    std::vector<std::string> warnings = model.warnings;
    const auto& report = model.report;
    const auto note = [&](std::size_t count, const std::string& why) {
        if (count == 0) return;
        warnings.push_back(model.name + ": " + std::to_string(count) + " of " +
                           std::to_string(report.faces_in) + " faces are left out: " + why);
    };
    note(report.zero_area, "no area");
    note(report.few_corners, "fewer than 3 different corners");
    return warnings;
}

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
    warn_of_normals(model, soup, normals);
    return model;
}

}  // namespace scanlight::apps
