// How near Scanlight comes to what the machine can do at all: to a bare loop that tests z and
// stores, and to setting the picture's bytes.

#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "apps/peers/alternate.h"
#include "apps/peers/bare_layers.h"
#include "apps/peers/bare_loop.h"
#include "apps/peers/bare_rows.h"
#include "apps/peers/options.h"
#include "apps/peers/stage.h"
#include "apps/peers/surfaces.h"
#include "mesh/build.h"
#include "mesh/triangulate.h"
#include "render/renderer.h"

namespace scanlight::peers {

namespace {

constexpr int layer_count = 8;

struct Job {
    std::string name;
    double pixels;
    std::function<void()> work;
};

/// Jobs to be compared with the first of them.
struct Group {
    std::string name;
    std::vector<Job> jobs;
};

/// A stage and what it takes to draw it.
class Frames {
public:
    Frames(raster::Viewport size, int threads, LayerOrder order)
        : stage_(layers(order, aspect_of(size)), View::window, size),
          renderer_({threads, {}}),
          picture_(size, 0) {}

    void draw(render::Shading shading) {
        render::Settings settings;
        settings.shading = shading;
        settings.cull = render::Cull::back;
        settings.sides = render::Sides::one;
        renderer_.draw(stage_.scene(), settings, picture_, raster::Encoding::linear);
    }

private:
    static mesh::Mesh layers(LayerOrder order, double aspect) {
        const auto soup = full_screen_layers(layer_count, order, aspect, window_distance());
        return mesh::triangulated(mesh::build(soup, {mesh::NormalWeight::file}).mesh);
    }

    Stage stage_;
    render::Renderer renderer_;
    raster::Plane<raster::PackedPixel> picture_;
};

Group row_group(int length) {
    const auto rows = std::make_shared<BareRows>(length);
    const render::LanePath& path = *render::lane_paths().front();
    return {"spans of " + std::to_string(length) + " pixels in one row, 1 thread",
            {{"bare loop", rows->pixels(), [rows] { rows->draw_bare(); }},
             {"depth and item", rows->pixels(), [rows, &path] { rows->draw_items(path); }},
             {"Gouraud", rows->pixels(), [rows, &path] { rows->draw_gouraud(path); }}}};
}

std::string words_of(LayerOrder order) {
    return order == LayerOrder::back_to_front ? "back to front" : "front to back";
}

Group layer_group(raster::Viewport size, int threads, LayerOrder order) {
    using render::Shading;
    const auto bare = std::make_shared<BareLayers>(size, threads, layer_count, order);
    const auto frames = std::make_shared<Frames>(size, threads, order);
    Group group{std::to_string(layer_count) + " layers of " + std::to_string(size.width) + "x" +
                    std::to_string(size.height) + " " + words_of(order) +
                    ", threads: " + std::to_string(threads),
                {{"bare loop", bare->pixels(), [bare] { bare->draw(); }}}};
    for (const auto& [name, shading] : {std::pair{"flat", Shading::flat},
                                        {"Gouraud", Shading::gouraud},
                                        {"Phong", Shading::phong}}) {
        group.jobs.push_back(
            {name, bare->pixels(), [frames, shading = shading] { frames->draw(shading); }});
    }
    group.jobs.push_back(
        {"memset of the picture", bare->pixels() / layer_count, [bare] { bare->clear(); }});
    return group;
}

/// Spans and bands that stay in the cache, then whole frames.
std::vector<std::function<Group()>> groups_of(const Options& options) {
    using enum LayerOrder;
    std::vector<std::function<Group()>> groups;
    for (const int length : {512, 1920}) {
        groups.push_back([length] { return row_group(length); });
        groups.push_back([length] { return layer_group({length, 16}, 1, back_to_front); });
    }
    for (const raster::Viewport size : options.sizes) {
        for (const int threads : options.threads) {
            for (const LayerOrder order : {back_to_front, front_to_back})
                groups.push_back([=] { return layer_group(size, threads, order); });
        }
    }
    return groups;
}

void print_head(const std::string& group) {
    std::printf("\n%-60s %9s %12s %16s\n", group.c_str(), "ms", "ns a pixel", "bare loop's = 1");
}

void print_line(const Job& job, const Times& bare, const Times& times) {
    const double seconds = median(times);
    std::printf("  %-58s %9.3f %12.3f %16.2f\n", job.name.c_str(), 1e3 * seconds,
                1e9 * seconds / job.pixels, median(ratios(bare, times)));
}

std::string json_line(const std::string& group, const Job& job, const Times& times) {
    const nlohmann::ordered_json json{
        {"group", group}, {"job", job.name}, {"pixels", job.pixels}, {"seconds", times}};
    return json.dump() + "\n";
}

void measure(const Group& group, int rounds, std::ostream& json) {
    constexpr double seconds_a_round = 0.1;
    std::vector<std::function<void()>> work;
    for (const Job& job : group.jobs)
        work.push_back(job.work);
    const auto times = alternate(work, rounds, seconds_a_round);
    print_head(group.name);
    for (std::size_t i = 0; i < times.size(); ++i) {
        print_line(group.jobs[i], times.front(), times[i]);
        json << json_line(group.name, group.jobs[i], times[i]);
    }
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    CLI::App app("Scanlight against a bare loop that tests z and stores, in turns");
    Options options;
    add_options(app, options);
    CLI11_PARSE(app, argc, argv);
    std::ofstream json;
    if (!options.json_path.empty()) json.open(options.json_path);
    std::printf(
        "Scanlight by %s, the bare loop by %s; the last column: speed as a share of the "
        "bare loop's\n",
        std::string(raster::lane_paths().front()->name).c_str(), bare_instructions().c_str());
    for (const auto& group : groups_of(options))
        measure(group(), options.rounds, json);
    return 0;
}

}  // namespace

}  // namespace scanlight::peers

int main(int argc, char** argv) {
    using namespace scanlight::peers;
    return status_of("scanlight-bench-limit", [&] { return run(argc, argv); });
}
