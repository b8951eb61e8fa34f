#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/print_data.h"
#include "apps/scene/json.h"
#include "apps/scene/models.h"
#include "apps/scene/read_scene.h"
#include "mesh/bounds.h"
#include "mesh/mtl_text.h"
#include "raster/save_file.h"

namespace scanlight::apps {

namespace {

struct InfoOptions {
    std::string input;
    bool json = false;
    std::string mtl;  // where the materials go
};

/// A corner of a bounding box: floats of the file.
Json json_of(const glm::dvec3& v) {
    Json list = Json::array();
    for (int k = 0; k < 3; ++k)
        list.push_back(json_number(static_cast<float>(v[k])));
    return list;
}

Json materials_json(const mesh::Mesh& mesh) {
    Json list = Json::array();
    for (const auto& material : mesh.materials) {
        if (!material.name.empty()) list.push_back(material.name);
    }
    return list;
}

std::size_t largest_polygon(const mesh::Mesh& mesh) {
    std::size_t largest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        largest = std::max(largest, mesh.face(f).size());
    }
    return largest;
}

Json json_of(const Model& model) {
    const auto& report = model.report;
    const mesh::Mesh& mesh = model.mesh;
    const mesh::Box box = mesh::bounding_box(mesh);
    return {{"input", model.name},
            {"faces", report.faces_in},
            {"drawn", report.drawn},
            {"dropped",
             {{"zero_area", report.zero_area}, {"fewer_than_3_corners", report.few_corners}}},
            {"largest_polygon", largest_polygon(mesh)},
            {"vertices", report.vertices},
            {"drawn_vertices", mesh.vertices.size()},
            {"isolated_points", report.isolated_points},
            {"edges", report.edges},
            {"boundary_edges", report.boundary_edges},
            {"components", report.components},
            {"closed", report.closed()},
            {"manifold", report.manifold()},
            {"repaired",
             {{"faces_given_corners_of_their_own", report.split_faces},
              {"points_doubled", report.split_vertices}}},
            {"has_uvs", mesh.vertices.has_uvs()},
            {"has_colours", mesh.vertices.has_colors()},
            {"materials", materials_json(mesh)},
            {"low", json_of(box.low)},
            {"high", json_of(box.high)},
            {"warnings", model.warnings}};
}

/// Of a mesh itself, or of all meshes of a scene.
Json json_of(const Models& models, const std::string& input) {
    if (!names_scene(input)) return json_of(models.all.front());
    Json meshes = Json::array();
    for (const Model& model : models.all)
        meshes.push_back(json_of(model));
    return {{"input", input}, {"objects", models.of_object.size()}, {"meshes", meshes}};
}

std::string words_of(std::string key) {
    std::ranges::replace(key, '_', ' ');
    return key;
}

std::string as_words(const Json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_structured()) return value.dump();
    std::string text;
    for (const auto& [key, item] : value.items()) {
        text += (text.empty()        ? ""
                 : value.is_object() ? ", "
                                     : "  ") +
                (value.is_object() ? words_of(key) + " " : std::string()) + as_words(item);
    }
    return text.empty() ? "none" : text;
}

std::string lines_of(const Json& json) {
    std::string text;
    for (const auto& [key, value] : json.items()) {
        text += words_of(key) + std::string(key.size() < 17 ? 17 - key.size() : 1, ' ') +
                as_words(value) + "\n";
    }
    return text;
}

/// Of all meshes.
std::vector<mesh::Material> materials_in(const Models& models) {
    std::vector<mesh::Material> materials;
    for (const Model& model : models.all)
        std::ranges::copy(model.mesh.materials, std::back_inserter(materials));
    return materials;
}

void info(const InfoOptions& options) {
    SceneOptions scene;
    set_input(scene, options.input);
    const Models models = load_models(scene);
    if (!options.mtl.empty()) raster::save_file(options.mtl, mesh::mtl_text(materials_in(models)));
    if (options.mtl == "-") return;
    if (options.json) return print_data(json_text(json_of(models, options.input)));
    std::string text;
    for (const Model& model : models.all)
        text += (text.empty() ? "" : "\n") + lines_of(json_of(model));
    print_data(text);
}

}  // namespace

void add_info_command(CLI::App& program) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand(
        "info", "What a mesh file, or each of a scene file, holds and what was repaired");
    command
        ->add_option("input", options->input,
                     "mesh file, - or a built-in shape; or a scene file, for all its meshes")
        ->required()
        ->type_name("IN");
    command->add_flag("--json", options->json, "as JSON");
    command
        ->add_option("--mtl", options->mtl,
                     "the mesh's materials as one MTL file, in full and in order; - writes them to "
                     "standard\noutput, and nothing else")
        ->type_name("FILE");
    command->footer(
        "Examples:\n  scanlight info bunny.obj\n  scanlight info part.stl --json\n"
        "  scanlight info car.obj --mtl car-in-order.mtl");
    command->callback([options] { info(*options); });
}

}  // namespace scanlight::apps
