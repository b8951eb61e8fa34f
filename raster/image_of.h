#pragma once

#include <utility>

#include "raster/framebuffer.h"
#include "raster/image.h"

namespace scanlight::raster {

/// A new image, filled by `write(samples of a pixel, the plane's value there)`.
template <class Sample, class Value, class Write>
Image<Sample> image_of(const Plane<Value>& plane, int channels, Write&& write) {
    Image<Sample> image(plane.width(), plane.height(), channels);
    for (int y = 0; y < plane.height(); ++y) {
        for (int x = 0; x < plane.width(); ++x)
            write(image.pixel(x, y), plane.at(x, y));
    }
    return image;
}

}  // namespace scanlight::raster
