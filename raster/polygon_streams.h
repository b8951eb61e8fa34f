#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/clip.h"
#include "raster/rows.h"
#include "raster/streams.h"
#include "raster/vertex.h"

namespace scanlight::raster {

/// The polygons of one mesh on the screen, as plain arrays: one stream a number, so that a vector's
/// worth of vertices loads at once. Borrowed; the owner outlives it.
struct PolygonStreams {
    std::span<const std::int32_t> x, y, z;      // of each vertex: SubPixel, SubPixel, Depth
    std::span<const std::int32_t> outside;      // the clip planes beyond which it lies: their bits
    std::span<const std::uint32_t> corners;     // indices of vertices
    std::span<const std::uint32_t> face_begin;  // faces + 1 of them, into `corners`
    bool mirrored = false;                      // front faces run clockwise
    std::int32_t outside_of_any = ~0;           // `outside` of all vertices joined, or more

    std::span<const std::uint32_t> face(std::size_t f) const {
        return corners.subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
    }
    bool are_triangles() const { return corners.size() == 3 * (face_begin.size() - 1); }
    /// Where vertex `v` is; only of vertices inside the view volume.
    ScreenVertex<0> corner(std::uint32_t v) const { return {x[v], y[v], z[v], {}}; }
};

/// The bit of a clip plane in `PolygonStreams::outside`.
constexpr std::int32_t outside_bit(ClipPlane plane) {
    return std::int32_t{1} << static_cast<int>(plane);
}

// A polygon on its way to the bands is its face's number with two flags.
using FaceItem = std::uint32_t;
inline constexpr FaceItem back_flag = 1u << 31;  // it shows its back
inline constexpr FaceItem walk_flag = 1u << 30;  // its values come from the walk down its edges
inline constexpr FaceItem face_mask = walk_flag - 1;
inline constexpr std::size_t most_faces = face_mask;

/// Which polygons to leave out, by the way they run on the screen.
struct CullRule {
    bool front = false;
    bool back = false;
};

/// What became of some polygons.
struct FateCounts {
    std::size_t outside = 0;
    std::size_t culled = 0;
    std::size_t drawn = 0;
};

/// Polygons that go on: seen, and with a pixel's centre in their box; or passed on, to be culled
/// one by one. One element more than a vector is needed behind the last, for whole vectors are
/// written.
struct Survivors {
    std::vector<std::int32_t> item;            // FaceItem
    std::vector<std::int32_t> y_begin, y_end;  // their rows
    std::size_t count = 0;

    void reserve(std::size_t n) {
        if (item.size() >= n) return;
        item.resize(n);
        y_begin.resize(n);
        y_end.resize(n);
    }
    std::size_t bytes() const { return bytes_held(item, y_begin, y_end); }
    /// A polygon that is yet to be culled: it has no rows, not even none.
    void pass_on(FaceItem face) { set(count++, face, {0, -1}); }
    bool is_passed_on(std::size_t i) const { return y_end[i] < 0; }
    void set(std::size_t i, FaceItem face, Rows rows) {
        item[i] = static_cast<std::int32_t>(face);
        y_begin[i] = rows.y_begin;
        y_end[i] = rows.y_end;
    }
};

}  // namespace scanlight::raster
