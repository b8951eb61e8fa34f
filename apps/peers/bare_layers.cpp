#include "apps/peers/bare_layers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "apps/peers/bare_loop.h"

namespace scanlight::peers {

namespace {

constexpr std::size_t page = 4096;

/// The first place in `memory` that lies half a page apart from `other`, modulo a page: were they
/// to lie at the same place of their pages, a store to the one would hold up loads of the other.
raster::Depth* apart_from(const void* other, raster::Depth* memory) {
    const std::size_t wanted = reinterpret_cast<std::uintptr_t>(other) + page / 2;
    const std::size_t bytes = (wanted - reinterpret_cast<std::uintptr_t>(memory)) % page;
    return memory + bytes / sizeof(raster::Depth);
}

}  // namespace

BareLayers::BareLayers(raster::Viewport size, int threads, int layers, LayerOrder order)
    : picture_(size, 0),
      workers_(threads),
      layers_(layers),
      order_(order),
      memories_(static_cast<std::size_t>(workers_.count())) {
    const std::size_t band = static_cast<std::size_t>(size.width) * rows_a_band;
    for (auto& memory : memories_)
        memory.resize(band + page / sizeof(raster::Depth));
}

double BareLayers::pixels() const {
    return static_cast<double>(layers_) * picture_.width() * picture_.height();
}

raster::Depth BareLayers::depth_of(int layer) const {
    const int from_front = order_ == LayerOrder::back_to_front ? layers_ - layer : layer + 1;
    return from_front * 1024;
}

void BareLayers::draw() {
    const int bands = (picture_.height() + rows_a_band - 1) / rows_a_band;
    workers_.for_each(static_cast<std::size_t>(bands), [&](int worker, std::size_t band) {
        draw_band(memories_[static_cast<std::size_t>(worker)], static_cast<int>(band));
    });
}

void BareLayers::draw_band(std::vector<raster::Depth>& memory, int band) {
    const int begin = band * rows_a_band;
    const int end = std::min(begin + rows_a_band, picture_.height());
    const auto width = static_cast<std::size_t>(picture_.width());
    raster::Depth* const depth = apart_from(picture_.row(begin).data(), memory.data());
    std::fill_n(depth, width * static_cast<std::size_t>(end - begin), raster::depth_clear);
    for (int layer = 0; layer < layers_; ++layer) {
        for (int y = begin; y < end; ++y) {
            bare_span(depth + width * static_cast<std::size_t>(y - begin), picture_.row(y).data(),
                      width, depth_of(layer), static_cast<raster::PackedPixel>(layer));
        }
    }
}

void BareLayers::clear() {
    workers_.for_each(static_cast<std::size_t>(picture_.height()), [&](int, std::size_t y) {
        const auto row = picture_.row(static_cast<int>(y));
        std::memset(row.data(), 0, row.size_bytes());
    });
}

}  // namespace scanlight::peers
