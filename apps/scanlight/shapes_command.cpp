#include <CLI/CLI.hpp>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/print_data.h"
#include "mesh/shapes.h"

namespace scanlight::apps {

namespace {

std::string shapes_text() {
    constexpr std::size_t name_width = 14;
    std::string text;
    for (const auto& shape : mesh::list_shapes()) {
        const bool has_parameters = !shape.parameters.empty();
        const std::string gap(has_parameters ? name_width - shape.name.size() : 0, ' ');
        text += shape.name + gap + shape.parameters + "\n";
    }
    return text;
}

}  // namespace

void add_shapes_command(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("shapes", "The built-in shapes and their parameters");
    command->footer(
        "Parameters follow the name: torus:48,24, polygon:0,1:-1,-1:1,-1.\nExample:\n"
        "  scanlight shapes");
    command->callback([] { print_data(shapes_text()); });
}

}  // namespace scanlight::apps
