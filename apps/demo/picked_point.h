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
    shading::Vec3<double> point;  // world space
    Directions directions;
};

/// At a pixel that shows a surface.
PickedPoint picked_point(const Stage& stage, const Pixel& pixel);

}  // namespace scanlight::demo
