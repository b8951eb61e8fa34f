#include <CLI/CLI.hpp>
#include <memory>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/print_data.h"
#include "apps/scene/read_scene.h"
#include "apps/scene/reference.h"
#include "apps/scene/usage_error.h"
#include "apps/scene/write_scene.h"

namespace scanlight::apps {

namespace {

struct SceneCommand {
    std::string input;
    bool reference = false;
    bool schema = false;
};

/// All it includes in one file, with paths from the folder in which the program runs.
std::string in_one_file(const std::string& input) {
    if (!names_scene(input))
        throw UsageError(input + ": expected a scene file: one that ends in .toml, or scene:PATH");
    SceneOptions options;
    set_input(options, input);
    return scene_text(options, "");
}

void print_scene(const SceneCommand& command) {
    if (command.reference) return print_data(scene_reference());
    if (command.schema) return print_data(scene_schema());
    if (command.input.empty()) throw UsageError("scene: expected IN, --reference or --schema");
    print_data(in_one_file(command.input));
}

}  // namespace

void add_scene_command(CLI::App& program) {
    auto options = std::make_shared<SceneCommand>();
    CLI::App* command =
        program.add_subcommand("scene", "Checks a scene file, or tells what one may say");
    CLI::Option* input =
        command
            ->add_option("input", options->input,
                         "scene file, or scene:- for standard input: printed as it is understood,\n"
                         "with all that it includes")
            ->type_name("IN");
    CLI::Option* reference =
        command->add_flag("--reference", options->reference, "all tables and keys, in Markdown")
            ->excludes(input);
    command->add_flag("--schema", options->schema, "all tables and keys, as JSON Schema")
        ->excludes(input)
        ->excludes(reference);
    command->footer(
        "Examples:\n"
        "  scanlight scene room.toml\n"
        "  scanlight scene --reference\n"
        "  scanlight scene --schema > scene.schema.json");
    command->callback([options] { print_scene(*options); });
}

}  // namespace scanlight::apps
