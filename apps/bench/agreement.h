#pragma once

#include <string>

#include "raster/framebuffer.h"

namespace scanlight::bench {

/// How far two methods' colours may lie apart, of a full intensity of 1: a tenth of a step of an
/// 8-bit picture.
inline constexpr float color_bound = 1.0f / 2560;

/// Throws std::runtime_error naming `method` if more than `most` pixels differ by more than
/// `color_bound` or are covered in one picture only: what draws something else is not worth timing.
void require_same_picture(const std::string& method, const raster::Plane<raster::Rgba>& expected,
                          const raster::Plane<raster::Rgba>& actual, int most);

}  // namespace scanlight::bench
