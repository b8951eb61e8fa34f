// Scanlight against Mesa's llvmpipe: the same meshes, camera and light, drawn in turns.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/peers/contest.h"
#include "apps/peers/options.h"
#include "apps/peers/report.h"
#include "apps/peers/stages.h"

namespace scanlight::peers {

namespace {

/// A column of the table: how a mesh is shaded, by which model if not the one asked for, and what
/// it wears.
struct Look {
    render::Shading shading;
    Coat coat = Coat::none;
    std::optional<shading::Illumination> illumination = {};
};
using render::Shading;
const std::map<std::string, Look> looks{
    {"flat", {Shading::flat}},
    {"gouraud", {Shading::gouraud}},
    {"phong", {Shading::phong}},
    {"texture", {Shading::phong, Coat::texture}},
    {"bump", {Shading::phong, Coat::bump}},
    {"cook-torrance", {Shading::phong, Coat::none, shading::Illumination::cook_torrance}}};
const std::map<std::string, shading::Illumination> illuminations{
    {"phong", shading::Illumination::phong}, {"blinn", shading::Illumination::blinn}};
const std::map<std::string, render::Distances> distances{{"finite", render::Distances::finite},
                                                         {"infinite", render::Distances::infinite}};

struct PeerOptions : Options {
    std::vector<std::string> scenes;  // empty: all
    std::vector<std::string> shadings{"flat",    "gouraud", "phong",
                                      "texture", "bump",    "cook-torrance"};
    std::string illumination = "phong";
    std::string distances = "finite";
    std::string mesh_path;
};

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const StagePlan& plan : usual_stages())
        names.push_back(plan.name);
    for (const ShadowStagePlan& plan : shadow_stages())
        names.push_back(plan.name);
    return names;
}

void add_peer_options(CLI::App& app, PeerOptions& options) {
    add_options(app, options);
    app.add_option("--scene", options.scenes, "Only these scenes")
        ->delimiter(',')
        ->check(CLI::IsMember(scene_names()));
    app.add_option("--shading", options.shadings, "Only these shadings")
        ->delimiter(',')
        ->check(CLI::IsMember(looks));
    app.add_option("--illumination", options.illumination, "The highlight's model")
        ->check(CLI::IsMember(illuminations))
        ->capture_default_str();
    app.add_option("--distances", options.distances, "Where the eye is for the illumination")
        ->check(CLI::IsMember(distances))
        ->capture_default_str();
    app.add_option("--mesh", options.mesh_path, "A mesh file, beside the scenes of --scene");
}

std::vector<StagePlan> plans_of(const PeerOptions& options) {
    std::vector<StagePlan> plans;
    for (StagePlan& plan : usual_stages()) {
        const auto& wanted = options.scenes;
        const bool is_wanted = std::ranges::find(wanted, plan.name) != wanted.end();
        if (is_wanted || (wanted.empty() && options.mesh_path.empty())) plans.push_back(plan);
    }
    if (!options.mesh_path.empty()) plans.push_back(stage_from_file(options.mesh_path));
    return plans;
}

std::vector<ShadowStagePlan> shadow_plans_of(const PeerOptions& options) {
    std::vector<ShadowStagePlan> plans;
    for (ShadowStagePlan& plan : shadow_stages()) {
        const auto& wanted = options.scenes;
        const bool is_wanted = std::ranges::find(wanted, plan.name) != wanted.end();
        if (is_wanted || (wanted.empty() && options.mesh_path.empty())) plans.push_back(plan);
    }
    return plans;
}

/// The same on both sides: back faces are culled, so that only fronts are lit.
render::Settings settings_of(const PeerOptions& options, const Look& look) {
    render::Settings settings;
    settings.shading = look.shading;
    settings.illumination = look.illumination.value_or(illuminations.at(options.illumination));
    settings.distances = distances.at(options.distances);
    settings.cull = render::Cull::back;
    settings.sides = render::Sides::one;
    return settings;
}

/// All contests of one process.
class Tournament {
public:
    Tournament(const PeerOptions& options, int threads)
        : options_(options), renderer_({threads, {}}) {
        if (!options.json_path.empty()) json_.open(options.json_path, std::ios::app);
    }

    void run() {
        for (const raster::Viewport size : options_.sizes) {
            run(size);
            run_shadows(size);
        }
        if (disagreements_ > 0)
            throw std::runtime_error(std::to_string(disagreements_) + " pictures disagree");
    }

private:
    void run(raster::Viewport size) {
        const GlTarget target(size);
        std::cout << table_head(size, renderer_.threads(), std::string(renderer_.instructions()),
                                target.renderer());
        for (const StagePlan& plan : plans_of(options_)) {
            Stage stage(plan.mesh(aspect_of(size)), plan.view, size);
            for (const std::string& shading : options_.shadings)
                run(target, stage, plan.name, shading);
        }
        for (const std::string& shading : options_.shadings)
            if (ratios_.contains(shading)) std::cout << mean_line(shading, ratios_.at(shading));
        ratios_.clear();
    }

    void run_shadows(raster::Viewport size) {
        if (shadow_plans_of(options_).empty()) return;
        const GlTarget target(size, GlTarget::Stencil::eight_bits);
        for (const ShadowStagePlan& plan : shadow_plans_of(options_)) {
            const ShadowStage stage(plan.caster(), size);
            const ShadowOutcome outcome = contest(renderer_, target, stage, options_.rounds);
            const std::size_t triangles = triangle_count(stage.caster());
            disagreements_ += agrees(outcome.frame.agreement) ? 0 : 1;
            print({size, renderer_.threads(), plan.name, triangles, "frame"}, outcome.frame);
            print({size, renderer_.threads(), plan.name, triangles, "volumes"}, outcome.shadows);
        }
    }

    /// Meshes without (u, v) wear no coats.
    void run(const GlTarget& target, Stage& stage, const std::string& name,
             const std::string& shading) {
        const Look& look = looks.at(shading);
        if (look.coat != Coat::none && !stage.mesh().vertices.has_uvs()) return;
        stage.wear(look.coat);
        const Entry entry{stage.size(), renderer_.threads(), name, triangle_count(stage.mesh()),
                          shading};
        const Outcome outcome = contest(renderer_, target, stage, settings_of(options_, look),
                                        look.coat, options_.rounds);
        disagreements_ += agrees(outcome.agreement) ? 0 : 1;
        if (!outcome.ours.empty()) ratios_[shading].push_back(median_ratio(outcome));
        print(entry, outcome);
    }

    void print(const Entry& entry, const Outcome& outcome) {
        std::cout << table_line(entry, outcome) << std::flush;
        json_ << json_line(entry, outcome) << std::flush;
    }

    const PeerOptions& options_;
    render::Renderer renderer_;
    std::ofstream json_;
    std::map<std::string, Times> ratios_;  // of the scenes, by shading
    int disagreements_ = 0;
};

/// Of llvmpipe's threads: the one that calls it works alone if there are none, and otherwise feeds
/// them and waits.
std::string extra_threads(int threads) {
    return std::to_string(threads == 1 ? 0 : threads);
}

constexpr const char* program = "scanlight-bench-peers";

/// Does the work in a process of its own, for llvmpipe reads its number of threads but once.
/// Returns its exit code.
int in_process(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        const int code = status_of(program, [&] {
            work();
            return 0;
        });
        std::cout << std::flush;
        _exit(code);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child)
        throw std::runtime_error("cannot start a process");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

int run(int argc, char** argv) {
    CLI::App app("Scanlight against Mesa's llvmpipe, in turns: milliseconds a frame");
    PeerOptions options;
    add_peer_options(app, options);
    CLI11_PARSE(app, argc, argv);
    if (!options.json_path.empty()) std::ofstream(options.json_path, std::ios::trunc);
    int code = 0;
    for (const int threads : options.threads) {
        code |= in_process([&] {
            setenv("LP_NUM_THREADS", extra_threads(threads).c_str(), 1);
            Tournament(options, threads).run();
        });
    }
    return code;
}

}  // namespace

}  // namespace scanlight::peers

int main(int argc, char** argv) {
    using namespace scanlight::peers;
    return status_of(program, [&] { return run(argc, argv); });
}
