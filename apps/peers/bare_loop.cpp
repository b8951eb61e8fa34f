// Compiled once for each instruction set; see Highway's "foreach_target".
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "apps/peers/bare_loop.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "apps/peers/bare_loop.h"

HWY_BEFORE_NAMESPACE();
namespace scanlight::peers::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void span(raster::Depth* depth, raster::PackedPixel* color, std::size_t count, raster::Depth z,
          raster::PackedPixel pixel) {
    const hn::ScalableTag<raster::Depth> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto new_z = hn::Set(d, z);
    const auto new_color = hn::Set(du, pixel);
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto old_z = hn::LoadU(d, depth + i);
        const auto nearer = hn::Lt(new_z, old_z);
        const auto old_color = hn::LoadU(du, color + i);
        hn::StoreU(hn::IfThenElse(nearer, new_z, old_z), d, depth + i);
        hn::StoreU(hn::IfThenElse(hn::RebindMask(du, nearer), new_color, old_color), du, color + i);
    }
    for (; i < count; ++i) {
        if (z >= depth[i]) continue;
        depth[i] = z;
        color[i] = pixel;
    }
}

std::string instructions() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace scanlight::peers::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace scanlight::peers {

namespace {

HWY_EXPORT(span);
HWY_EXPORT(instructions);

}  // namespace

void bare_span(raster::Depth* depth, raster::PackedPixel* color, std::size_t count, raster::Depth z,
               raster::PackedPixel pixel) {
    HWY_DYNAMIC_DISPATCH(span)(depth, color, count, z, pixel);
}

std::string bare_instructions() {
    return HWY_DYNAMIC_DISPATCH(instructions)();
}

}  // namespace scanlight::peers
#endif
