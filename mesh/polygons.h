#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// The faces of a soup that can be drawn, in their order. Every face has at least 3 distinct points
/// and an area; no corner repeats the point of the one before it.
///
/// A corner also names the half-edge that leaves it for the next corner of its face.
struct Polygons {
    std::vector<std::uint32_t> point;         // one a corner, into the soup's positions
    std::vector<std::uint32_t> soup_corners;  // one a corner; empty if none was left out
    std::vector<std::uint32_t> face_of;       // one a corner, until forget_neighbours()
    std::vector<bool> alone;  // one a corner, until forget_neighbours(): its face came by this
                              // point before, so that it must have a vertex of its own

    std::vector<std::uint32_t> begin{0};   // faces + 1 of them, into the corners
    std::vector<std::uint32_t> soup_face;  // one a face
    std::vector<glm::dvec3> normals;       // one a face, unit, until forget_normals()

    std::size_t zero_area = 0;    // faces left out: nothing to fill
    std::size_t few_corners = 0;  // faces left out: fewer than 3 distinct points

    std::size_t face_count() const { return begin.size() - 1; }
    std::size_t corner_count() const { return point.size(); }

    /// Which of the soup's corners this one is.
    std::uint32_t soup_corner(std::uint32_t corner) const {
        return soup_corners.empty() ? corner : soup_corners[corner];
    }

    std::uint32_t next(std::uint32_t corner) const {
        const std::uint32_t face = face_of[corner];
        return corner + 1 == begin[face + 1] ? begin[face] : corner + 1;
    }
    std::uint32_t previous(std::uint32_t corner) const {
        const std::uint32_t face = face_of[corner];
        return corner == begin[face] ? begin[face + 1] - 1 : corner - 1;
    }

    /// Gives back the memory of what no one asks any more, next() and previous() with it. Of a
    /// large mesh the one is as much as its points, the other twice as much.
    void forget_neighbours() {
        face_of = std::vector<std::uint32_t>();
        alone = std::vector<bool>();
    }
    void forget_normals() { normals = std::vector<glm::dvec3>(); }
};

/// Leaves out repeated neighbours of corners, then the faces that cannot be drawn, and counts them.
Polygons drawable_polygons(const PolygonSoup& soup);

}  // namespace scanlight::mesh
