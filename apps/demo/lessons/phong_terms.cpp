#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/measure.h"
#include "apps/demo/picked_point.h"
#include "apps/demo/settings.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/text_table.h"
#include "shading/blinn.h"
#include "shading/phong.h"

namespace scanlight::demo {

namespace {

const std::string all_light = "ka=#a03020 kd=#a03020 ks=0.7";

/// R·V with n, N·H with n, and N·H with 4n.
struct Highlight {
    std::string illumination;
    double n;
};

const std::vector<std::string> models{"r-v", "n-h", "n-h-matched"};

Highlight highlight_of(const std::string& model, double n) {
    if (model == "r-v") return {"phong", n};
    return {"blinn", model == "n-h" ? n : 4.0 * n};
}

std::string arguments(const std::string& material, const std::string& light,
                      const Highlight& highlight) {
    return "teapot:6 --ambient 0.25 --light " + light + " --illumination " +
           highlight.illumination + " --material \"" + material +
           " n=" + apps::fixed(highlight.n, 0) + "\"";
}

const std::string light = "-0.7,0.7,1";

std::string highlight_alone(const Highlight& highlight) {
    return arguments("ka=0 kd=0 ks=0.7", light, highlight);
}

/// The picture of each term alone, and of all, by the same camera.
struct Terms {
    Stage ambient, diffuse, specular, all;

    Terms(const Highlight& highlight, raster::Viewport size)
        : ambient(arguments("ka=#a03020 kd=0 ks=0", light, {"phong", 1}), size),
          diffuse(arguments("ka=0 kd=#a03020 ks=0", light, {"phong", 1}), size),
          specular(highlight_alone(highlight), size),
          all(arguments(all_light, light, highlight), size) {}
};

Curve curve_of(const std::string& key, const Stage& stage, int y) {
    return {key, surface_points(stage.framebuffer(), y)};
}

/// Beside one another, whichever is chosen.
Plot highlights_plot(double n, raster::Viewport size, int y) {
    Plot plot{"highlights-plot",
              {"pixel-axis", 0, static_cast<double>(size.width)},
              {"light-axis", 0, 0.8},
              {}};
    for (const std::string& model : models) {
        const Stage stage(highlight_alone(highlight_of(model, n)), size);
        plot.curves.push_back(curve_of("word-" + model, stage, y));
    }
    return plot;
}

std::vector<Number> numbers_at(const PickedPoint& point, const Highlight& highlight) {
    const auto& [N, L, V, H, R] = point.directions;
    const shading::Exponent n(highlight.n);
    const double term =
        highlight.illumination == "phong" ? shading::phong(N, L, V, n) : shading::blinn(N, L, H, n);
    return {{"n-l", shading::dot(N, L), 3},
            {"r-v", shading::dot(R, V), 3},
            {"n-h", shading::dot(N, H), 3},
            {"exponent", highlight.n},
            {"highlight-term", term, 3}};
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const double n = settings.at("n");
    const Highlight highlight = highlight_of(word_of(models, settings, "model"), n);
    const Terms terms(highlight, size);
    // Of a picture of 4:3 beside the highlight.
    const Pixel wanted{size.width * 26 / 100, size.height * 40 / 100};
    const PickedPoint picked = picked_point(terms.all, wanted);
    const Pixel& pixel = picked.pixel;
    Screen screen{{terms.ambient.panel("ambient", means), terms.diffuse.panel("diffuse", means),
                   terms.specular.panel("specular", means), terms.all.panel("all", means)},
                  numbers_at(picked, highlight)};
    screen.panels.back().marks = {mark_at(pixel)};
    screen.plots = {
        {"terms-plot",
         {"pixel-axis", 0, static_cast<double>(size.width)},
         {"light-axis", 0, 1.2},
         {curve_of("ambient", terms.ambient, pixel.y), curve_of("diffuse", terms.diffuse, pixel.y),
          curve_of("specular", terms.specular, pixel.y), curve_of("all", terms.all, pixel.y)}},
        highlights_plot(n, size, pixel.y)};
    return screen;
}

}  // namespace

Lesson phong_terms_lesson() {
    return {"phong-terms",
            {{"n", "n", Slider{10, 90, 9, 20}}, {"model", "", Choice{models}}},
            {{"shading/ambient.h", "ambient"},
             {"shading/lambert.h", "lambert"},
             {"shading/phong.h", "phong"},
             {"shading/blinn.h", "blinn"}},
            draw};
}

}  // namespace scanlight::demo
