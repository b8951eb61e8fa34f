#include "apps/scanlight/color_format.h"

#include "apps/scene/usage_error.h"

namespace scanlight::apps {

raster::ImageFormat color_format(const std::string& path) {
    if (raster::promises_grey(path)) {
        throw UsageError(path + ": a PGM holds no colours; these do: .png .ppm .pfm .hdr");
    }
    return raster::image_format(path);
}

}  // namespace scanlight::apps
