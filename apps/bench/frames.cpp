#include "apps/bench/frames.h"

#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "apps/bench/agreement.h"
#include "apps/bench/medians.h"
#include "apps/bench/methods.h"
#include "apps/bench/stage.h"
#include "apps/bench/stopwatch.h"
#include "apps/bench/table.h"
#include "render/draw.h"
#include "render/flat.h"
#include "render/gouraud.h"
#include "render/phong.h"

namespace scanlight::bench {

namespace {

/// Where two surfaces meet, the last bits of depth decide which one a pixel shows, and a floating
/// point depth has fewer of them.
constexpr int pixels_in_doubt = 400;

using Stages = std::array<Stage, 2>;

render::Settings settings_for(render::Shading shading) {
    render::Settings settings;
    settings.shading = shading;
    settings.illumination = shading::Illumination::phong;
    settings.cull = render::Cull::back;
    return settings;
}

/// All that is done before interpolation begins, done once.
template <class Technique>
struct Prepared {
    const Stage* stage;
    const render::Settings* settings;
    Technique technique;
    std::vector<SeenTriangle<Technique::attribute_count>> triangles;
};

/// The part of a frame that the methods differ in: from triangles on the screen to pixels.
template <template <int> class Method, class Technique>
class TrianglesJob {
public:
    explicit TrianglesJob(const Prepared<Technique>& prepared)
        : prepared_(&prepared), target_(prepared.stage->viewport()) {}

    void clear() { target_.clear(); }
    void draw() {
        const Technique& technique = prepared_->technique;
        for (const auto& [face, triangle] : prepared_->triangles) {
            const auto& common = technique.polygon(face, triangle.side);
            const auto shade = [&](const raster::Fragment<N>& fragment) {
                return technique.shade(fragment, common);
            };
            method_.draw(Corners<N>(triangle.corners), target_, shade);
        }
    }
    int pixels() const { return prepared_->stage->pixels(); }
    const raster::Plane<raster::Rgba>& picture() const { return target_.color; }

private:
    static constexpr int N = Technique::attribute_count;

    const Prepared<Technique>* prepared_;
    Method<N> method_;
    Target<typename Method<N>::Z> target_;
};

/// The whole frame as a program draws it: vertices, clipping and clearing too.
class FrameJob {
public:
    FrameJob(const Stage& stage, const render::Settings& settings)
        : stage_(&stage), settings_(&settings) {}

    void clear() {}
    void draw() {
        benchmark::DoNotOptimize(render::draw(stage_->scene(), *settings_, stage_->viewport()));
    }
    int pixels() const { return stage_->pixels(); }

private:
    const Stage* stage_;
    const render::Settings* settings_;
};

/// `technique_for(stage)` makes the technique. The stages and the settings outlive the result.
template <class TechniqueFor>
auto prepare(const Stages& stages, const render::Settings& settings, TechniqueFor&& technique_for) {
    std::vector<Prepared<decltype(technique_for(stages.front()))>> prepared;
    for (const Stage& stage : stages) {
        auto technique = technique_for(stage);
        auto triangles = seen_triangles(stage, technique, settings);
        prepared.push_back({&stage, &settings, std::move(technique), std::move(triangles)});
    }
    return prepared;
}

template <template <int> class Method, class Technique>
raster::Plane<raster::Rgba> picture(const Prepared<Technique>& prepared) {
    TrianglesJob<Method, Technique> job(prepared);
    job.draw();
    return job.picture();
}

/// One row of the table: a method, on each stage.
template <template <int> class Method, class Technique>
Row add_row(const std::string& group, const std::string& label,
            const std::vector<Prepared<Technique>>& all) {
    Row row{group, label, {}};
    for (const auto& prepared : all) {
        row.keys.push_back(group + "/" + label + "/" + prepared.stage->name());
        require_same_picture(row.keys.back(), picture<IncrementalEdges>(prepared),
                             picture<Method>(prepared), pixels_in_doubt);
        measure(row.keys.back(), [&prepared] { return TrianglesJob<Method, Technique>(prepared); });
    }
    return row;
}

template <class Technique>
Row add_whole_frames(const std::string& group, const std::vector<Prepared<Technique>>& all) {
    Row row{group, "whole frame", {}};
    for (const auto& prepared : all) {
        row.keys.push_back(group + "/" + row.label + "/" + prepared.stage->name());
        measure(row.keys.back(),
                [&prepared] { return FrameJob(*prepared.stage, *prepared.settings); });
    }
    return row;
}

template <class Technique>
void add_methods(const std::string& group, const std::vector<Prepared<Technique>>& all,
                 Table& table) {
    table.rows.push_back(add_row<IncrementalEdges>(group, "incremental, edges and spans", all));
    table.rows.push_back(add_row<IncrementalPlane>(group, "incremental, plane", all));
    table.rows.push_back(add_row<DirectBilinear>(group, "bilinear formula a pixel", all));
    table.rows.push_back(add_row<Barycentric>(group, "barycentric weights a pixel", all));
    table.rows.push_back(add_whole_frames(group, all));
}

void describe(std::ostream& out, const Stages& stages) {
    out << "1920 x 1080, one light, one thread. Methods: triangles on the screen to pixels;\n"
           "whole frame: all of render::draw.";
    for (const Stage& stage : stages) {
        out << ' ' << stage.name() << ": " << stage.triangle_count() << " triangles.";
    }
    out << '\n';
}

}  // namespace

void compare_frames(int repetitions, const std::string& json_path) {
    const Stages stages{Stage("teapot:16"), Stage("icosphere:7")};
    const auto for_flat = settings_for(render::Shading::flat);
    const auto for_gouraud = settings_for(render::Shading::gouraud);
    const auto for_phong = settings_for(render::Shading::phong);
    const auto flat = prepare(stages, for_flat, [&](const Stage& s) {
        return render::FlatTechnique(s.placed(), s.frame(), for_flat);
    });
    const auto gouraud = prepare(stages, for_gouraud, [&](const Stage& s) {
        return render::GouraudTechnique(s.placed(), s.frame(), for_gouraud);
    });
    const auto phong = prepare(stages, for_phong, [&](const Stage& s) {
        using Technique = render::PhongTechnique<shading::Phong, render::Paint::material>;
        return Technique(s.placed(), s.frame(), shading::Phong{});
    });

    Table table{"milliseconds a frame", {}, {}};
    for (const Stage& stage : stages)
        table.columns.push_back(stage.name());
    add_methods("flat", flat, table);
    add_methods("Gouraud", gouraud, table);
    add_methods("Phong", phong, table);
    const Medians medians = run_all(repetitions, json_path);
    describe(std::cout, stages);
    print(std::cout, table,
          [&](const std::string& key) { return medians[key].nanoseconds * 1e-6; });
}

}  // namespace scanlight::bench
