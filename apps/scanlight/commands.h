#pragma once

namespace CLI {
class App;
}

namespace scanlight::apps {

// Each adds one subcommand to the program; its callback runs it. A callback that ends with a
// negative result throws `Dissimilar`.

void add_render_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_diff_command(CLI::App& program);
void add_grade_command(CLI::App& program);
void add_steps_command(CLI::App& program);
void add_gallery_command(CLI::App& program);
void add_shapes_command(CLI::App& program);
void add_turntable_command(CLI::App& program);
void add_scene_command(CLI::App& program);

/// Exit status 1: the pictures differ. Not an error.
struct Dissimilar {};

}  // namespace scanlight::apps
