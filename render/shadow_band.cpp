#include "render/shadow_band.h"

#include <algorithm>

#include "render/shadow_map.h"

namespace scanlight::render {

namespace {

/// The bits of the maps' lights that do not reach a point.
std::int32_t hidden_lights(std::span<const ShadowMap> maps, const glm::vec3& point) {
    std::uint32_t bits = 0;
    for (std::size_t light = 0; light < maps.size(); ++light)
        bits |= maps[light].share(point) == 0.0f ? 1u << light : 0u;
    return static_cast<std::int32_t>(bits);
}

}  // namespace

void ShadowBand::clear(const raster::VisibleBand& band) {
    const raster::Rows rows = band.rows();
    y_begin_ = rows.y_begin;
    stride_ = band.stride();
    shadowed_.assign(static_cast<std::size_t>(stride_ * (rows.y_end - rows.y_begin)), 0);
}

void ShadowBand::find(std::span<const ObjectPass> passes, raster::VisibleBand& band, int number,
                      std::span<Stencil> stencils) {
    clear(band);
    counts_.resize(shadowed_.size());
    find_farthest(band);
    const raster::Rows rows = band.rows();
    const raster::CountedBand counted{rows, stride_, band.depth_row(rows.y_begin), counts_.data(),
                                      farthest_.data()};
    const std::size_t lights = passes.empty() ? 0 : passes.front().sides.size();
    for (std::size_t light = 0; light < lights; ++light) {
        find(light, passes, counted, number);
        if (!stencils.empty()) copy_counts(rows, stencils[light]);
    }
}

void ShadowBand::find(std::span<const ShadowMap> maps, const Frame& frame,
                      raster::VisibleBand& band) {
    clear(band);
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        const raster::Depth* depth = band.depth_row(y);
        std::int32_t* shadowed = shadowed_.data() + stride_ * (y - y_begin_);
        for (int x = 0; x < band.width(); ++x) {
            if (depth[x] < raster::depth_clear)
                shadowed[x] = hidden_lights(maps, frame.point_at(x, y, depth[x]));
        }
    }
}

void ShadowBand::find_farthest(raster::VisibleBand& band) {
    constexpr int tile_width = 1 << raster::CountedBand::tile_bits;
    farthest_.assign(static_cast<std::size_t>(band.width() / tile_width + 1), 0);
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        const raster::Depth* depth = band.depth_row(y);
        for (int x = 0; x < band.width(); x += tile_width) {
            const int end = std::min(x + tile_width, band.width());
            raster::Depth& farthest = farthest_[static_cast<std::size_t>(x / tile_width)];
            farthest = std::max(farthest, *std::max_element(depth + x, depth + end));
        }
    }
}

void ShadowBand::find(std::size_t light, std::span<const ObjectPass> passes,
                      const raster::CountedBand& band, int number) {
    std::ranges::fill(counts_, 0);
    for (const ObjectPass& pass : passes) {
        const ShadowSides& sides = pass.sides[light];
        for (const std::uint32_t i : sides.band(number))
            counter_.count(sides.triangles()[i], band);
    }
    const auto bit = static_cast<std::int32_t>(1u << light);
    for (std::size_t i = 0; i < counts_.size(); ++i)
        shadowed_[i] |= counts_[i] != 0 ? bit : 0;
}

void ShadowBand::copy_counts(raster::Rows rows, Stencil& to) const {
    for (int y = rows.y_begin; y < rows.y_end; ++y)
        std::copy_n(counts_.data() + stride_ * (y - y_begin_), to.width(), to.row(y).begin());
}

}  // namespace scanlight::render
