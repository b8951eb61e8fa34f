#pragma once

#include <vector>

#include "apps/peers/surfaces.h"
#include "raster/framebuffer.h"
#include "raster/packed.h"
#include "raster/workers.h"

namespace scanlight::peers {

/// Full-screen layers by the bare loop and nothing else: bands of 16 rows, whose depth stays in the
/// cache, as a z-buffer without any geometry would draw them.
class BareLayers {
public:
    BareLayers(raster::Viewport size, int threads, int layers, LayerOrder order);

    void draw();
    /// Sets each byte of the picture, by the same threads.
    void clear();
    double pixels() const;  // of all layers

private:
    static constexpr int rows_a_band = 16;

    void draw_band(std::vector<raster::Depth>& memory, int band);
    raster::Depth depth_of(int layer) const;

    raster::Plane<raster::PackedPixel> picture_;
    raster::Workers workers_;
    int layers_;
    LayerOrder order_;
    std::vector<std::vector<raster::Depth>> memories_;  // one a thread
};

}  // namespace scanlight::peers
