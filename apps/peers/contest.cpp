#include "apps/peers/contest.h"

#include "apps/peers/llvmpipe.h"
#include "apps/peers/llvmpipe_shadows.h"

namespace scanlight::peers {

namespace {

constexpr double seconds_a_round = 0.15;

Times less(const Times& a, const Times& b) {
    Times result;
    for (std::size_t i = 0; i < a.size(); ++i)
        result.push_back(a[i] - b[i]);
    return result;
}

}  // namespace

Outcome contest(render::Renderer& ours, const GlTarget& theirs, const Stage& stage,
                const render::Settings& settings, Coat coat, int rounds) {
    Llvmpipe llvmpipe(theirs, stage, settings, coat);
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

ShadowOutcome contest(render::Renderer& ours, const GlTarget& theirs, const ShadowStage& stage,
                      int rounds) {
    render::Settings without;
    without.sides = render::Sides::one;
    render::Settings with = without;
    with.shadows = render::Shadows::zfail;
    LlvmpipeShadows llvmpipe(theirs, stage, without);
    raster::Plane<raster::PackedPixel> picture(stage.size(), 0);
    const auto draw = [&](const render::Settings& settings) {
        ours.draw(stage.scene(), settings, picture, raster::Encoding::linear);
    };
    draw(with);
    llvmpipe.draw();
    ShadowOutcome outcome;
    outcome.frame.agreement = agreement(picture, llvmpipe.picture());
    outcome.shadows.agreement = outcome.frame.agreement;
    if (!agrees(outcome.frame.agreement)) return outcome;
    const auto times = alternate({[&] { draw(with); }, [&] { llvmpipe.draw(); },
                                  [&] { draw(without); }, [&] { llvmpipe.draw_unshadowed(); }},
                                 rounds, seconds_a_round);
    outcome.frame.ours = times[0];
    outcome.frame.theirs = times[1];
    outcome.shadows.ours = less(times[0], times[2]);
    outcome.shadows.theirs = less(times[1], times[3]);
    return outcome;
}

}  // namespace scanlight::peers
