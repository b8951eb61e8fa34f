#pragma once

#include "raster/lanes/attributes.h"
#include "raster/lanes/triangles.h"
#include "raster/visible_band.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// One of a vector of prepared triangles, on its way to the pixels of a band, which keep what
/// `Keep` says.
template <class Keep>
struct OneTriangle {
    using Values = PlaneValues<Keep::attributes>;

    const PreparedTriangles& t;
    int lane;
    const PreparedAttributes<Keep::attributes>& attributes;
    const Keep& keep;
    std::int32_t own;
    VisibleBand& band;

    int x_begin() const { return t.x_begin[lane]; }
    int x_end() const { return t.x_end[lane]; }
    int y_begin() const { return t.y_begin[lane]; }
    int y_end() const { return t.y_end[lane]; }
    DepthPlane depth_plane() const { return t.depth_plane(lane); }
    std::int64_t depth_at(int x, int y) const { return t.depth_at(lane, x, y); }
};

}  // namespace scanlight::raster::HWY_NAMESPACE
