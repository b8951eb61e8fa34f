#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/count_triangle.h"
#include "raster/framebuffer.h"
#include "raster/visible_band.h"
#include "render/object_pass.h"

namespace scanlight::render {

/// How many shadow volumes of a light each pixel's surface lies in.
using Stencil = raster::Plane<std::int32_t>;

class ShadowMap;

/// Which lights do not reach the surfaces that a band shows: for each pixel a bit a light. Keeps
/// its memory from one band to the next.
class ShadowBand {
public:
    /// As many lights as there are bits.
    static constexpr std::size_t most_lights = 32;

    /// Counts the shadow volumes of all objects, a light after the other, against the depths of the
    /// `number`-th band. All objects have the sides of as many lights. Where `stencils` are given,
    /// a picture's plane a light, the band's rows of them get the counts.
    void find(std::span<const ObjectPass> passes, raster::VisibleBand& band, int number,
              std::span<Stencil> stencils);

    /// Asks the maps of all lights for what the pixels of a band show.
    void find(std::span<const ShadowMap> maps, const Frame& frame, raster::VisibleBand& band);

    /// A whole vector may be read at its end.
    const std::int32_t* row(int y) const { return shadowed_.data() + stride_ * (y - y_begin_); }

    std::size_t bytes() const { return raster::bytes_held(counts_, shadowed_, farthest_); }

private:
    void clear(const raster::VisibleBand& band);
    void find_farthest(raster::VisibleBand& band);
    void find(std::size_t light, std::span<const ObjectPass> passes,
              const raster::CountedBand& band, int number);
    void copy_counts(raster::Rows rows, Stencil& to) const;

    std::ptrdiff_t stride_ = 0;
    int y_begin_ = 0;
    raster::LineVector<std::int32_t> counts_;  // the stencil
    raster::LineVector<std::int32_t> shadowed_;
    std::vector<raster::Depth> farthest_;  // see `raster::CountedBand`
    raster::TriangleCounter counter_;
};

}  // namespace scanlight::render
