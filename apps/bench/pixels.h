#pragma once

#include <cstddef>

#include "apps/bench/float_vertex.h"
#include "apps/bench/target.h"
#include "raster/fragments.h"

namespace scanlight::bench {

/// The pixels of a span whose values are worked out one by one: `values_at(x)` at each pixel's
/// centre (x in pixels). Depth test and storing are those of `raster::draw_span`.
template <int N, class ValuesAt, class Shade>
void draw_pixels(int y, int x_begin, int x_end, Target<float>& target, ValuesAt&& values_at,
                 Shade&& shade) {
    const auto depth_row = target.depth.row(y);
    const auto color_row = target.color.row(y);
    for (int x = x_begin; x < x_end; ++x) {
        const auto column = static_cast<std::size_t>(x);
        const FloatValues<N> values = values_at(static_cast<float>(x) + 0.5f);
        if (values.z >= depth_row[column]) continue;
        depth_row[column] = values.z;
        const auto depth = static_cast<raster::Depth>(values.z);
        color_row[column] = shade(raster::Fragment<N>{x, y, depth, values.attributes});
    }
}

}  // namespace scanlight::bench
