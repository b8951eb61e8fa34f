#pragma once

#include "apps/peers/gl.h"
#include "apps/peers/gl_target.h"
#include "apps/peers/stage.h"
#include "render/scene.h"

namespace scanlight::peers {

/// Mesa's software renderer with a stage in its buffers, ready to draw it again and again. How many
/// threads it has it reads from the environment when the process begins to use it.
class Llvmpipe {
public:
    /// Draws into `target`, which is current.
    Llvmpipe(const GlTarget& target, const Stage& stage, const render::Settings& settings,
             Coat coat);
    ~Llvmpipe();
    Llvmpipe(const Llvmpipe&) = delete;
    Llvmpipe& operator=(const Llvmpipe&) = delete;

    /// Clears, draws, and waits until all is done.
    void draw();
    raster::Plane<raster::PackedPixel> picture() const { return target_.picture(); }

private:
    const GlTarget& target_;
    GLuint program_ = 0;
    GLuint texture_ = 0;
    GLuint vertex_array_ = 0;
    GLuint buffers_[2] = {};  // vertices, corners
    GLsizei corners_ = 0;
};

}  // namespace scanlight::peers
