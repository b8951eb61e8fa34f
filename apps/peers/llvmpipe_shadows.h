#pragma once

#include "apps/peers/gl.h"
#include "apps/peers/gl_target.h"
#include "apps/peers/shadow_stage.h"

namespace scanlight::peers {

/// llvmpipe drawing shadows by the literature's passes: ambient light and depth; the shadow volume
/// of the caster into the stencil, both sides at once, z-fail with depth clamped; the light where
/// nothing was counted. The volume of the caster's lit faces is in a buffer, ready made: of a
/// directional light a triangle a silhouette edge, which meet at infinity, and the faces.
class LlvmpipeShadows {
public:
    /// Draws into `target`, which is current and has a stencil. Phong shading only.
    LlvmpipeShadows(const GlTarget& target, const ShadowStage& stage,
                    const render::Settings& settings);
    ~LlvmpipeShadows();
    LlvmpipeShadows(const LlvmpipeShadows&) = delete;
    LlvmpipeShadows& operator=(const LlvmpipeShadows&) = delete;

    /// All passes; or, without shadows, the last alone.
    void draw();
    void draw_unshadowed();
    raster::Plane<raster::PackedPixel> picture() const { return target_.picture(); }

private:
    struct Batch {
        GLuint program = 0;
        GLuint vertex_array = 0;
        GLuint buffers[2] = {};
        GLsizei corners = 0;
    };

    void draw(const Batch& batch) const;
    static void release(Batch& batch);

    const GlTarget& target_;
    Batch lit_, ambient_, volume_;
};

}  // namespace scanlight::peers
