#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/bins.h"
#include "raster/count_triangle.h"
#include "render/scene.h"

namespace scanlight::render {

struct ObjectPass;

/// The sides of an object's shadow volume on the screen, in triangles, sorted into bands of rows.
///
/// Counted from the eye to the surface they are all that matters, and tell what z-fail tells: the
/// faces of the object itself, at one end of its volume, are nowhere nearer than what is seen, for
/// they have been drawn; and nothing lies beyond the other end. What the near plane cuts open is
/// closed, see `raster::near_section`.
class ShadowSides {
public:
    /// Of the object of a pass whose vertices are placed.
    void find(const ObjectPass& pass, const glm::dvec4& light, const raster::Bands& bands);

    /// Those that touch the i-th band: numbers of `triangles()`.
    std::span<const std::uint32_t> band(int i) const { return bands_[static_cast<std::size_t>(i)]; }
    std::span<const raster::CountedTriangle> triangles() const { return triangles_; }

    std::size_t bytes() const;

private:
    void find_triangles(const ObjectPass& pass, const glm::dvec4& light);
    void sort_into(const raster::Bands& bands);

    std::vector<raster::CountedTriangle> triangles_;
    std::vector<std::vector<std::uint32_t>> bands_;
};

/// Whether sides are all that is to be counted. A polygon that was not drawn may be nearer than
/// what is seen; and so may parts of one that winds round itself, which no triangle or quad does.
bool sides_suffice(const Scene& scene, const Settings& settings);

}  // namespace scanlight::render
