#pragma once

#include "raster/fixed.h"

namespace scanlight::raster {

/// Rows of a picture from `y_begin` to before `y_end`.
struct Rows {
    int y_begin = 0;
    int y_end = max_size;
};

}  // namespace scanlight::raster
