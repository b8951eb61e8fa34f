#pragma once

#include "raster/lanes/attributes.h"
#include "raster/lanes/keep.h"
#include "raster/lanes/triangles.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// Pixels of tiny triangles that have passed the depth test and wait, in their order, until a
/// vector's worth or more of them is kept at once.
template <class Keep>
class WaitingPixels {
public:
    WaitingPixels(const Keep& keep, VisibleBand& band) : keep_(keep), band_(band) {}

    /// Pixel (x, y) at `place` of the band, of a triangle.
    void add(std::ptrdiff_t place, std::int32_t own,
             const PreparedAttributes<Keep::attributes>& planes, int lane, int x, int y) {
        place_[count_] = place;
        own_[count_] = own;
        for (int k = 0; k < Keep::attributes; ++k)
            values_[k][count_] = PlaneValues<Keep::attributes>::attribute_at(planes, k, lane, x, y);
        ++count_;
    }

    /// Makes room for one more triangle.
    void make_room() {
        if (count_ > most - tiny_columns * tiny_rows) keep();
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

/// How many rows of a tiny box hold pixels.
inline std::size_t tiny_row_count(std::uint32_t pixels) {
    const std::uint32_t pairs = pixels | pixels >> 1;
    return static_cast<std::size_t>(std::popcount((pairs | pairs >> 2) & 0x11111111u));
}

/// Tests the pixels of one tiny triangle one by one; those that pass wait for their numbers.
template <class Keep>
PixelCounts draw_tiny(const PreparedTriangles& t, int lane,
                      const PreparedAttributes<Keep::attributes>& attributes, std::int32_t own,
                      VisibleBand& band, WaitingPixels<Keep>& waiting) {
    const DepthPlane plane = t.depth_plane(lane);
    const int x = t.x_begin[lane];
    const int y = t.y_begin[lane];
    const std::int64_t z = t.depth_at(lane, x, y);
    Depth* const depth = band.depth_row(band.rows().y_begin);
    const auto pixels = static_cast<std::uint32_t>(t.pixels[lane]);
    std::size_t passed = 0;
    waiting.make_room();
    for (std::uint32_t left = pixels; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const int i = bit % tiny_columns;
        const int j = bit / tiny_columns;
        const Depth d = Ramp{z + i * plane.dx + j * plane.dy, 0}.get();
        const std::ptrdiff_t place = (y + j - band.rows().y_begin) * band.stride() + x + i;
        if (d >= depth[place]) continue;
        depth[place] = d;
        waiting.add(place, own, attributes, lane, x + i, y + j);
        ++passed;
    }
    return {tiny_row_count(pixels), static_cast<std::size_t>(std::popcount(pixels)), passed};
}

}  // namespace scanlight::raster::HWY_NAMESPACE
