#pragma once

#include "apps/demo/measure.h"
#include "apps/demo/stage.h"
#include "shading/vector.h"

namespace scanlight::demo {

/// The unit vectors that the formulas of light take, world space, of the first light.
struct Directions {
    shading::Vec3<double> N, L, V, H, R;
};

/// What a pixel shows.
struct PickedPoint {
    Pixel pixel;
    Directions directions;
};

/// At the pixel nearest to `wanted` that shows a surface; where none does, at `wanted`, with N 0.
PickedPoint picked_point(const Stage& stage, const Pixel& wanted);

}  // namespace scanlight::demo
