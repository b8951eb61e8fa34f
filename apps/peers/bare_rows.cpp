#include "apps/peers/bare_rows.h"

#include <algorithm>
#include <cstddef>

#include "apps/peers/bare_loop.h"

namespace scanlight::peers {

namespace {

/// Half a page from the depths, modulo a page; see `BareLayers`.
std::size_t values_begin(int length) {
    return (static_cast<std::size_t>(length) + raster::VisibleBand::overrun + 1023) / 1024 * 1024 +
           512;
}

raster::Depth depth_of(int span) {
    return raster::depth_far - 4096 * (span + 1);
}

}  // namespace

BareRows::BareRows(int length)
    : length_(length), values_begin_(values_begin(length)), memory_(2 * values_begin_ + 1024) {}

void BareRows::clear() {
    std::fill_n(depth(), length_, raster::depth_clear);
}

void BareRows::draw_bare() {
    clear();
    for (int i = 0; i < spans; ++i) {
        bare_span(depth(), reinterpret_cast<raster::PackedPixel*>(values()),
                  static_cast<std::size_t>(length_), depth_of(i),
                  static_cast<raster::PackedPixel>(i));
    }
}

void BareRows::draw_ours(const raster::LanePath& path) {
    clear();
    for (int i = 0; i < spans; ++i) {
        const raster::Ramp ramp{std::int64_t{depth_of(i)} << raster::ramp_bits, 1000};
        path.draw_span(depth(), values(), 0, length_, ramp, i);
    }
}

}  // namespace scanlight::peers
