// What a frame costs, and on what that depends: triangles, pixels, layers, threads, vectors.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "apps/peers/alternate.h"
#include "apps/peers/chart.h"
#include "apps/peers/options.h"
#include "apps/peers/stage.h"
#include "apps/peers/surfaces.h"
#include "mesh/build.h"
#include "mesh/triangulate.h"
#include "render/draw.h"
#include "render/renderer.h"

namespace scanlight::peers {

namespace {

using render::Shading;
constexpr raster::Viewport full_hd{1920, 1080};
const std::vector<std::pair<std::string, Shading>> all_shadings = {
    {"flat", Shading::flat}, {"Gouraud", Shading::gouraud}, {"Phong", Shading::phong}};

using Job = std::function<void()>;
using StagePtr = std::shared_ptr<const Stage>;

render::Settings settings_for(Shading shading) {
    render::Settings settings;
    settings.shading = shading;
    settings.cull = render::Cull::back;
    settings.sides = render::Sides::one;
    return settings;
}

StagePtr sphere(std::uint32_t rings, raster::Viewport size) {
    return std::make_shared<Stage>(mesh::triangulated(mesh::build(displaced_sphere(rings)).mesh),
                                   View::framed, size);
}

StagePtr layers(std::uint32_t count, LayerOrder order) {
    const auto soup = full_screen_layers(count, order, aspect_of(full_hd), window_distance());
    return std::make_shared<Stage>(
        mesh::triangulated(mesh::build(soup, {mesh::NormalWeight::file}).mesh), View::window,
        full_hd);
}

/// Jobs share the memory they work in, for that of many would have gone cold when its turn comes.
class Workshop {
public:
    std::shared_ptr<render::Renderer> renderer(int threads, std::string_view instructions) {
        auto& renderer = renderers_[{threads, instructions}];
        if (!renderer)
            renderer = std::make_shared<render::Renderer>(render::Execution{threads, instructions});
        return renderer;
    }
    using Picture = raster::Plane<raster::PackedPixel>;
    std::shared_ptr<Picture> picture(raster::Viewport size) {
        auto& picture = pictures_[{size.width, size.height}];
        if (!picture) picture = std::make_shared<Picture>(size, 0);
        return picture;
    }

private:
    std::map<std::pair<int, std::string_view>, std::shared_ptr<render::Renderer>> renderers_;
    std::map<std::pair<int, int>, std::shared_ptr<Picture>> pictures_;
};

Job fast(Workshop& shop, const StagePtr& stage, Shading shading, int threads = 0,
         std::string_view instructions = {}) {
    const auto renderer = shop.renderer(threads, instructions);
    const auto picture = shop.picture(stage->size());
    return [=] {
        renderer->draw(stage->scene(), settings_for(shading), *picture, raster::Encoding::linear);
    };
}

Job textbook(const StagePtr& stage, Shading shading) {
    return [=] { render::draw(stage->scene(), settings_for(shading), stage->size()); };
}

/// A panel with the jobs that will fill it in: of each curve one a place.
struct Plan {
    Panel panel;
    std::vector<std::vector<Job>> jobs;

    void add(const std::string& curve, std::vector<Job> work) {
        panel.curves.push_back({curve, {}});
        jobs.push_back(std::move(work));
    }
};

/// A curve a shading, a place a stage.
Plan by_stage(Workshop& shop, const std::string& title,
              const std::vector<std::pair<std::string, StagePtr>>& stages) {
    Plan plan{{title, {}, {}}, {}};
    for (const auto& [place, stage] : stages)
        plan.panel.places.push_back(place);
    for (const auto& [name, shading] : all_shadings) {
        std::vector<Job> jobs;
        for (const auto& [place, stage] : stages)
            jobs.push_back(fast(shop, stage, shading));
        plan.add(name, jobs);
    }
    return plan;
}

Plan by_triangles(Workshop& shop) {
    std::vector<std::pair<std::string, StagePtr>> stages;
    for (const auto& [rings, name] : {std::pair{16u, "1k"},
                                      {32u, "4k"},
                                      {64u, "16k"},
                                      {128u, "66k"},
                                      {256u, "262k"},
                                      {512u, "1M"}})
        stages.emplace_back(name, sphere(rings, full_hd));
    return by_stage(shop, "milliseconds by triangles", stages);
}

Plan by_pixels(Workshop& shop) {
    std::vector<std::pair<std::string, StagePtr>> stages;
    for (const int height : {270, 540, 1080, 2160}) {
        const int width = height * 16 / 9;
        stages.emplace_back(std::to_string(width) + "x" + std::to_string(height),
                            sphere(128, {width, height}));
    }
    return by_stage(shop, "milliseconds by size, 66k triangles", stages);
}

Plan by_layers(Workshop& shop, LayerOrder order) {
    const std::string words =
        order == LayerOrder::back_to_front ? "back to front" : "front to back";
    std::vector<std::pair<std::string, StagePtr>> stages;
    for (const std::uint32_t count : {1u, 2u, 4u, 8u, 16u})
        stages.emplace_back(std::to_string(count), layers(count, order));
    return by_stage(shop, "milliseconds by full layers, " + words, stages);
}

/// Stages on which threads and vectors are compared.
std::vector<std::pair<std::string, StagePtr>> compared_stages() {
    return {{"sphere 1M", sphere(512, full_hd)},
            {"sphere 66k", sphere(128, full_hd)},
            {"8 layers", layers(8, LayerOrder::back_to_front)}};
}

Plan by_threads(Workshop& shop) {
    Plan plan{{"milliseconds by threads, Phong", {}, {}}, {}};
    const int processors = static_cast<int>(std::thread::hardware_concurrency());
    std::vector<int> counts;
    for (int count = 1; count <= processors; count *= 2)
        counts.push_back(count);
    for (const int count : counts)
        plan.panel.places.push_back(std::to_string(count));
    for (const auto& [name, stage] : compared_stages()) {
        std::vector<Job> jobs;
        for (const int count : counts)
            jobs.push_back(fast(shop, stage, Shading::phong, count));
        plan.add(name, jobs);
    }
    return plan;
}

Plan by_instructions(Workshop& shop) {
    Plan plan{{"milliseconds by vectors, 1 thread, Phong", {"textbook"}, {}}, {}};
    auto sets = render::instruction_sets();
    std::ranges::reverse(sets);
    for (const auto set : sets)
        plan.panel.places.emplace_back(set);
    for (const auto& [name, stage] : compared_stages()) {
        std::vector<Job> jobs{textbook(stage, Shading::phong)};
        for (const auto set : sets)
            jobs.push_back(fast(shop, stage, Shading::phong, 1, set));
        plan.add(name, jobs);
    }
    return plan;
}

Panel measured(Plan plan, int rounds) {
    constexpr double seconds_a_round = 0.05;
    std::vector<Job> all;
    for (const auto& jobs : plan.jobs)
        all.insert(all.end(), jobs.begin(), jobs.end());
    const auto times = alternate(all, rounds, seconds_a_round);
    std::size_t next = 0;
    for (Curve& curve : plan.panel.curves) {
        for (std::size_t i = 0; i < plan.panel.places.size(); ++i)
            curve.values.push_back(1e3 * median(times[next++]));
    }
    return plan.panel;
}

nlohmann::ordered_json json_of(const Panel& panel) {
    nlohmann::ordered_json json{{"title", panel.title}, {"places", panel.places}};
    for (const Curve& curve : panel.curves)
        json["milliseconds"][curve.name] = curve.values;
    return json;
}

void require_written(std::ofstream& file, const std::string& path) {
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

int run(int argc, char** argv) {
    CLI::App app("What a frame costs by triangles, pixels, layers, threads and vectors");
    int rounds = 5;
    std::string json_path, svg_path;
    app.add_option("--rounds", rounds, "Rounds to take the median of")
        ->check(CLI::Range(3, 1000))
        ->capture_default_str();
    app.add_option("--json", json_path, "Write all to this file");
    app.add_option("--svg", svg_path, "Draw the plot into this file");
    CLI11_PARSE(app, argc, argv);
    std::vector<Panel> panels;
    using enum LayerOrder;
    const std::vector<std::function<Plan(Workshop&)>> plans = {
        by_triangles,
        by_pixels,
        [](Workshop& shop) { return by_layers(shop, back_to_front); },
        [](Workshop& shop) { return by_layers(shop, front_to_back); },
        by_threads,
        by_instructions};
    for (const auto& plan : plans) {
        Workshop shop;
        panels.push_back(measured(plan(shop), rounds));
        print_table(std::cout, panels.back());
        std::cout.flush();
    }
    if (!json_path.empty()) {
        auto json = nlohmann::ordered_json::array();
        for (const Panel& panel : panels)
            json.push_back(json_of(panel));
        std::ofstream file(json_path);
        file << json.dump(2) << '\n';
        require_written(file, json_path);
    }
    if (!svg_path.empty()) {
        std::ofstream file(svg_path);
        draw_chart(file, panels);
        require_written(file, svg_path);
    }
    return 0;
}

}  // namespace

}  // namespace scanlight::peers

int main(int argc, char** argv) {
    using namespace scanlight::peers;
    return status_of("scanlight-bench-cost", [&] { return run(argc, argv); });
}
