#pragma once

#include "raster/lanes/keep.h"
#include "raster/lanes/pack.h"
#include "render/lanes/shade.h"

namespace scanlight::render::HWY_NAMESPACE {

// Light at once: pixels keep colours instead of what light would need. See raster/lanes/keep.h.

/// Pixels keep the colour of the polygon.
class KeepFlatColor {
public:
    static constexpr int attributes = 0;
    static constexpr int numbers = 1;

    KeepFlatColor(const ObjectPass& pass, raster::Encoding encoding)
        : technique_(pass), encoding_(encoding) {}

    Ints own(Ints item) const {
        const ColorLanes color = technique_.color_of(item);
        return encoding_ == raster::Encoding::srgb
                   ? pack_lanes<raster::Encoding::srgb>(color.x, color.y, color.z)
                   : pack_lanes<raster::Encoding::linear>(color.x, color.y, color.z);
    }
    Kept<1> of(Ints own, const Ints*) const { return {{own}}; }

private:
    FlatLanes technique_;
    raster::Encoding encoding_;
};

/// Pixels keep the colour that the intensities of the corners come to.
template <raster::Encoding encoding>
class KeepGouraudColor {
public:
    static constexpr int attributes = GouraudLanes::attributes;
    static constexpr int numbers = 1;

    explicit KeepGouraudColor(const ObjectPass& pass) : technique_(pass) {}

    Ints own(Ints) const { return Ints(0); }
    Kept<1> of(Ints, const Ints* a) const {
        if constexpr (encoding == raster::Encoding::linear) {
            if (is_undivided(a)) return {{pack_linear_multiples(a, technique_.unit())}};
        }
        const ColorLanes color = technique_.color_of(a);
        return {{pack_lanes<encoding>(color.x, color.y, color.z)}};
    }

private:
    GouraudLanes technique_;
};

}  // namespace scanlight::render::HWY_NAMESPACE
