#pragma once

#include "apps/peers/agreement.h"
#include "apps/peers/alternate.h"
#include "apps/peers/gl_target.h"
#include "apps/peers/shadow_stage.h"
#include "apps/peers/stage.h"
#include "render/renderer.h"

namespace scanlight::peers {

/// Two renderers that drew one stage in turns; seconds a frame, round by round.
struct Outcome {
    Times ours;
    Times theirs;
    Agreement agreement;
};

/// The stage wears the coat. Compares the pictures, then the times. Where the pictures disagree,
/// there are no times.
Outcome contest(render::Renderer& ours, const GlTarget& theirs, const Stage& stage,
                const render::Settings& settings, Coat coat, int rounds);

/// The same with shadows: whole frames, and what the shadows alone cost, which is the frame with
/// them less the frame without.
struct ShadowOutcome {
    Outcome frame;
    Outcome shadows;
};
ShadowOutcome contest(render::Renderer& ours, const GlTarget& theirs, const ShadowStage& stage,
                      int rounds);

}  // namespace scanlight::peers
