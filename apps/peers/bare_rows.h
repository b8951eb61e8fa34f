#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raster/lane_path.h"

namespace scanlight::peers {

/// Many long spans in one row, each nearer than the last: all stays in the nearest cache.
class BareRows {
public:
    explicit BareRows(int length);

    void draw_bare();
    /// The same by Scanlight's spans, which interpolate depth and write, instead of a colour, whose
    /// each pixel is.
    void draw_ours(const raster::LanePath& path);
    double pixels() const { return static_cast<double>(length_) * spans; }

private:
    static constexpr int spans = 1024;

    raster::Depth* depth() { return memory_.data(); }
    std::int32_t* values() { return memory_.data() + values_begin_; }
    void clear();

    int length_;
    std::size_t values_begin_;
    std::vector<std::int32_t> memory_;
};

}  // namespace scanlight::peers
