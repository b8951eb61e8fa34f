#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "apps/scanlight/commands.h"
#include "apps/scanlight/grades.h"
#include "apps/scanlight/grades_report.h"
#include "apps/scanlight/print_data.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

struct GradeOptions {
    std::string reference;
    std::vector<std::string> candidates;
    GradingRule rule;
    std::string difference_folder;
    bool json = false;
};

void grade(const GradeOptions& options) {
    const auto references = reference_pictures(options.reference);
    std::vector<CandidateGrades> all;
    for (const std::string& candidate : options.candidates)
        all.push_back(grades_of(candidate, references, options.rule));
    if (!options.difference_folder.empty())
        save_differences(options.difference_folder, references, all);
    print_data(options.json ? grades_json(all, options.rule) : grades_text(all, options.rule), {});
    for (const CandidateGrades& candidate : all) {
        if (!candidate.passes(options.rule)) throw Dissimilar();
    }
}

}  // namespace

void add_grade_command(CLI::App& program) {
    auto options = std::make_shared<GradeOptions>();
    CLI::App* command = program.add_subcommand(
        "grade", "How many points pictures earn, held against the right one");
    command
        ->add_option("reference", options->reference,
                     "the right picture, or a folder with all of an exercise")
        ->required()
        ->type_name("REFERENCE");
    command
        ->add_option("candidates", options->candidates,
                     "pictures; or, beside a folder of references, folders with pictures of the\n"
                     "same names")
        ->required()
        ->type_name("CANDIDATE");
    command
        ->add_option("--tolerance", options->rule.tolerance_levels,
                     "levels of 255 by which a channel of a right pixel may be off")
        ->check(CLI::Range(0.0, 255.0))
        ->capture_default_str()
        ->type_name("LEVELS");
    command
        ->add_option("--points", options->rule.points, "what a picture is worth that is all right")
        ->check(CLI::Range(1.0, 1e6))
        ->capture_default_str()
        ->type_name("N");
    command
        ->add_option("--pass", options->rule.pass_percent,
                     "the part of the points, in percent, that each candidate needs")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str()
        ->type_name("PERCENT");
    command
        ->add_option("--differences", options->difference_folder,
                     "put a difference picture here for each picture that is not all right")
        ->type_name("DIR");
    command->add_flag("--json", options->json, "as JSON");
    command->footer(
        "Of the background only what is wrong counts, so that an empty picture earns nothing. A\n"
        "missing or broken picture earns nothing, and the others are graded all the same.\n"
        "Exit status: 0 all pass, 1 some do not, 2 an error.\n"
        "Examples:\n"
        "  scanlight grade teapot.png handed-in/*.png\n"
        "  scanlight grade solutions/ students/*/ --points 5 --tolerance 1 --json");
    command->callback([options] { grade(*options); });
}

}  // namespace scanlight::apps
