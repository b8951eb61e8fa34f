#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/lane_path.h"

namespace scanlight::peers {

/// Many long spans in one row, each nearer than the last: all stays in the nearest cache.
class BareRows {
public:
    explicit BareRows(int length);

    void draw_bare();
    /// The same by Scanlight's spans, which interpolate depth; each pixel keeps whose it is.
    void draw_items(const render::LanePath& path);
    /// Each pixel keeps its colour, of three interpolated intensities and q.
    void draw_gouraud(const render::LanePath& path);
    double pixels() const { return static_cast<double>(length_) * spans; }

    static constexpr int spans = 1024;

private:
    void clear();

    int length_;
    raster::VisibleBand band_;
    std::vector<std::int32_t> zeros_;
    std::vector<std::uint32_t> corners_, begins_;
    render::ObjectPass pass_;
};

}  // namespace scanlight::peers
