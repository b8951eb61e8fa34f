#pragma once

#include <string>

#include "apps/peers/coat.h"
#include "apps/peers/gl.h"
#include "render/frame.h"
#include "render/scene.h"

namespace scanlight::peers {

/// A program in GLSL that lights as Scanlight does by these settings (Phong's or Blinn's model, or
/// Cook and Torrance's with a metal), ready to draw `GlGeometry` with; a coat goes with Phong
/// shading. A whole exponent is squarings here as there: `pow` is slower.
/// Throws std::runtime_error with the compiler's words; std::invalid_argument for another model.
GLuint gl_program(const render::Settings& settings, Coat coat,
                  const shading::Material<float>& material, const render::Frame& frame);

/// The two halves of a program.
struct GlSources {
    std::string vertex;
    std::string fragment;
};

/// A program of its own, with the same uniforms as far as it has them: clip_from_world, ambient,
/// diffuse, specular, light, viewpoint. Throws std::runtime_error with the compiler's words.
GLuint gl_program(const GlSources& sources, const shading::Material<float>& material,
                  const render::Frame& frame);

}  // namespace scanlight::peers
