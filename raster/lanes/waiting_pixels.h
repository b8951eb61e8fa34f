#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/lanes/keep.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// Pixels that have passed the depth test one by one, of tiny triangles and short spans. They wait,
/// in their order, until a vector's worth or more of them is kept at once.
template <class Keep>
class WaitingPixels {
public:
    WaitingPixels(const Keep& keep, VisibleBand& band) : keep_(keep), band_(band) {}

    /// The pixel at `place` of the band; `value_of(k)` is its k-th attribute. There must be room.
    template <class ValueOf>
    void add(std::ptrdiff_t place, std::int32_t own, ValueOf&& value_of) {
        place_[count_] = place;
        own_[count_] = own;
        for (int k = 0; k < Keep::attributes; ++k)
            values_[k][count_] = value_of(k);
        ++count_;
    }

    /// For so many pixels more.
    void make_room(int pixels) {
        if (count_ + pixels > most) keep();
    }

    /// Nobody waits any more.
    void keep() {
        for (int i = 0; i < count_; i += lane_count)
            keep_vector(i);
        count_ = 0;
    }

private:
    static constexpr int most = 256;

    void keep_vector(int i) {
        Ints values[Keep::attributes + 1];
        for (int k = 0; k < Keep::attributes; ++k)
            values[k] = load(values_[k] + i);
        const Kept<Keep::numbers> kept = keep_.of(load(own_ + i), values);
        const PixelPlace first = band_.row(band_.rows().y_begin);
        for (int number = 0; number < Keep::numbers; ++number)
            scatter(kept.number[number], i, first.kept(number));
    }

    /// One by one: where two are of one pixel, the later is the nearer.
    void scatter(Ints numbers, int i, std::int32_t* to) const {
        std::int32_t lanes[lane_count];
        store(numbers, lanes);
        const int n = count_ - i < lane_count ? count_ - i : lane_count;
        for (int lane = 0; lane < n; ++lane)
            to[place_[i + lane]] = lanes[lane];
    }

    const Keep& keep_;
    VisibleBand& band_;
    int count_ = 0;
    std::ptrdiff_t place_[most];
    std::int32_t own_[most + lane_count];
    std::int32_t values_[Keep::attributes + 1][most + lane_count];
};

}  // namespace scanlight::raster::HWY_NAMESPACE
