#include "apps/peers/contest.h"

#include "apps/peers/llvmpipe.h"

namespace scanlight::peers {

namespace {

constexpr double seconds_a_round = 0.15;

}  // namespace

Outcome contest(render::Renderer& ours, const GlTarget& theirs, const Stage& stage,
                const render::Settings& settings, int rounds) {
    Llvmpipe llvmpipe(theirs, stage, settings);
    raster::Plane<raster::PackedPixel> picture(stage.size(), 0);
    const auto draw_ours = [&] {
        ours.draw(stage.scene(), settings, picture, raster::Encoding::linear);
    };
    const auto draw_theirs = [&] { llvmpipe.draw(); };
    draw_ours();
    draw_theirs();
    Outcome outcome;
    outcome.agreement = agreement(picture, llvmpipe.picture());
    if (!agrees(outcome.agreement)) return outcome;
    const auto times = alternate({draw_ours, draw_theirs}, rounds, seconds_a_round);
    outcome.ours = times[0];
    outcome.theirs = times[1];
    return outcome;
}

}  // namespace scanlight::peers
