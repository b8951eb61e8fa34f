#pragma once

#include "apps/demo/window/painter.h"
#include "raster/compare.h"

namespace scanlight::apps::window {

/// How two views differ: the picture that `scanlight diff` draws, and its numbers.
struct Contrast {
    Pixels pixels;
    raster::Difference difference;
};

/// Of pictures of one size.
Contrast contrast_of(const Pixels& left, const Pixels& right);

}  // namespace scanlight::apps::window
