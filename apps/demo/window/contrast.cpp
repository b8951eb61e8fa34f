#include "apps/demo/window/contrast.h"

#include "raster/packed_image.h"

namespace scanlight::apps::window {

Contrast contrast_of(const Pixels& left, const Pixels& right) {
    const raster::AnyImage first = image_of(left, raster::Alpha::dropped);
    const raster::AnyImage second = image_of(right, raster::Alpha::dropped);
    return {raster::packed_image(raster::difference_image(first, second)),
            raster::compare(first, second)};
}

}  // namespace scanlight::apps::window
