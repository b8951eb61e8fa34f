#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/draw.h"
#include "render/renderer.h"
#include "tests/same_bits/test_scene.h"

namespace scanlight::same_bits {

inline constexpr int thread_counts[] = {1, 2, 3, 7, 16};

/// The fast path by every instruction set of this machine, each with so many threads.
std::vector<render::Renderer> renderers(std::span<const int> threads);

/// "AVX2, 7 threads".
std::string name_of(const render::Renderer& renderer);

/// The picture of a scene by the fast path.
render::Drawing draw(const TestScene& test, render::Renderer& renderer);

/// By the scanline walk, the oracle.
render::Drawing draw(const TestScene& test);

/// What is counted in the stencil for each light; of a scene without shadows, nothing.
std::vector<render::Stencil> count_shadows(const TestScene& test, render::Renderer& renderer);

/// By the scanline walk, for the scene's method or another one.
std::vector<render::Stencil> count_shadows(const TestScene& test, render::Shadows method);
std::vector<render::Stencil> count_shadows(const TestScene& test);

}  // namespace scanlight::same_bits
