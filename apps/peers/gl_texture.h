#pragma once

#include "apps/peers/coat.h"
#include "apps/peers/gl.h"

namespace scanlight::peers {

/// A coat's image as a texture of OpenGL, bound, with smaller versions of OpenGL's own making.
GLuint gl_texture(Coat coat);

}  // namespace scanlight::peers
