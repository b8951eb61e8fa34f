#pragma once

#include <string>

#include "apps/peers/gl.h"
#include "raster/framebuffer.h"
#include "raster/packed.h"

namespace scanlight::peers {

/// What llvmpipe draws into: 8 bits a channel and 24 bits of depth, in its own memory, so that no
/// frame is copied. Its rows run from top to bottom, as ours do.
/// Invariant: context and framebuffer are current. One in a process at a time.
class GlTarget {
public:
    enum class Stencil { none, eight_bits };

    /// Throws std::runtime_error if OSMesa has no llvmpipe or no OpenGL 3.3.
    explicit GlTarget(raster::Viewport size, Stencil stencil = Stencil::none);
    ~GlTarget();
    GlTarget(const GlTarget&) = delete;
    GlTarget& operator=(const GlTarget&) = delete;

    std::string renderer() const;  // its name, with the width of its vectors
    raster::Plane<raster::PackedPixel> picture() const;

private:
    raster::Viewport size_;
    OSMesaContext context_;
    raster::PackedPixel unused_ = 0;  // the picture that OSMesa would copy frames to
};

/// Throws std::runtime_error naming `what` if OpenGL has an error to tell.
void check_gl(const std::string& what);

}  // namespace scanlight::peers
