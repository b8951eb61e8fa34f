#include "apps/scanlight/means.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "apps/scanlight/choice_option.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

constexpr int most_threads = 256;

std::string joined(const std::vector<std::string_view>& names) {
    std::string list;
    for (const auto name : names)
        list.append(list.empty() ? "" : "|").append(name);
    return list;
}

/// The name as the renderer keeps it, which outlives the command line.
std::string_view parse_instructions(const std::string& text) {
    const auto names = render::instruction_sets();
    const auto found = std::ranges::find(names, text);
    if (found != names.end()) return *found;
    throw UsageError("--instructions '" + text + "': expected " + joined(names) +
                     ", which this machine runs");
}

}  // namespace

Words<DrawPath> words_beside(DrawPath) {
    using enum DrawPath;
    return {{"fast", fast}, {"textbook", textbook}};
}

void check(const Means& means) {
    const auto& [threads, instructions] = means.execution;
    if (means.path == DrawPath::fast || (threads <= 1 && instructions.empty())) return;
    throw UsageError("--path textbook draws by one thread, without vectors; --threads and " +
                     std::string("--instructions are the fast path's"));
}

void add_means_options(CLI::App& app, Means& means) {
    const HelpHeading heading(app, "Speed: the picture is the same, to the bit");
    add_choice(app, "--path", means.path,
               "by vectors and threads, or by the textbook's scanline walk");
    app.add_option("--threads", means.execution.threads,
                   "how many draw; 0 is one for each processor")
        ->type_name("N")
        ->check(
            CLI::Range(0, most_threads).description("from 0 to " + std::to_string(most_threads)))
        ->capture_default_str();
    const auto names = render::instruction_sets();
    app.add_option_function<std::string>(
           "--instructions",
           [&means](const std::string& text) {
               means.execution.instructions = parse_instructions(text);
           },
           "vector instructions, of those that this machine runs")
        ->type_name(joined(names))
        ->default_str(std::string(names.front()));
}

}  // namespace scanlight::apps
