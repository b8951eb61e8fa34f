#pragma once

#include "raster/lanes/numbers.h"
#include "raster/visible_band.h"

namespace scanlight::raster::HWY_NAMESPACE {

// What a pixel keeps of the surface nearest to it, besides the depth: a few 32-bit numbers. A rule
// says which, and has
//
//     static constexpr int attributes;  // how many are interpolated for it
//     static constexpr int numbers;     // how many are kept
//     Ints own(Ints item) const;        // of each polygon, a number of its own: a lane is a
//     polygon Kept<numbers> of(Ints own, const Ints* attributes) const;  // a lane is a pixel
//
// One that keeps only what lies behind something else has also, for a vector and for one pixel:
//
//     is_behind(depth, own, PixelPlace) const;

template <int count>
struct Kept {
    Ints number[count];
};

/// The polygon's item and the attributes as they are: light comes later. Items count on from
/// `first`, so that several objects are told apart.
template <int count>
struct KeepAttributes {
    static constexpr int attributes = count;
    static constexpr int numbers = count + 1;

    explicit KeepAttributes(std::int32_t first) : first_(first) {}

    Ints own(Ints item) const { return item + Ints(first_); }
    Kept<numbers> of(Ints own, const Ints* values) const {
        Kept<numbers> kept;
        kept.number[0] = own;
        for (int k = 0; k < count; ++k)
            kept.number[k + 1] = values[k];
        return kept;
    }

private:
    std::int32_t first_;
};
using KeepItem = KeepAttributes<0>;

/// Whether one pixel of a polygon passes the depth test.
template <class Keep>
bool is_seen(Depth z, std::int32_t own, const Keep& keep, PixelPlace at) {
    if (z >= *at.depth) return false;
    if constexpr (requires { keep.is_behind(z, own, at); }) return keep.is_behind(z, own, at);
    return true;
}

/// The z-buffer (Catmull 1974) for a vector of pixels: where `z` is nearer than what is there, it
/// and what `keep` makes of `values` take its place. At equal depth the first polygon drawn stays.
/// Returns how many passed.
template <class Keep, class Values>
int store_nearer(Mask covered, Ints z, const Keep& keep, Ints own, const Values& values,
                 PixelPlace at) {
    Mask nearer = covered & (z < load(at.depth));
    if constexpr (requires { keep.is_behind(z, own, at); })
        nearer = nearer & keep.is_behind(z, own, at);
    if (!any(nearer)) return 0;
    store_where(nearer, z, at.depth);
    Ints attributes[Keep::attributes + 1];
    values.get(attributes);
    const Kept<Keep::numbers> kept = keep.of(own, attributes);
    for (int i = 0; i < Keep::numbers; ++i)
        store_where(nearer, kept.number[i], at.kept(i));
    return count(nearer);
}

}  // namespace scanlight::raster::HWY_NAMESPACE
