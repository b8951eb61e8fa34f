#pragma once

#include <string>

#include "raster/save_image.h"

namespace scanlight::apps {

/// The format of a file of colours by its ending. Throws UsageError for one that promises grey,
/// ImageError for an unknown one.
raster::ImageFormat color_format(const std::string& path);

}  // namespace scanlight::apps
