#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/material.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

inline bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_finite(const Material& m) {
    return is_finite(m.ambient) && is_finite(m.diffuse) && is_finite(m.specular) &&
           is_finite(m.emission) && is_finite(m.filter) && std::isfinite(m.exponent) &&
           std::isfinite(m.opacity) && std::isfinite(m.refraction);
}

inline bool has_only_finite_numbers(const PolygonSoup& soup) {
    const auto all_finite = [](const auto& values) {
        return std::ranges::all_of(values, [](const auto& value) { return is_finite(value); });
    };
    return all_finite(soup.positions) && all_finite(soup.colors) && all_finite(soup.normals) &&
           all_finite(soup.materials) && std::ranges::all_of(soup.uvs, [](const glm::vec2& uv) {
               return std::isfinite(uv.x) && std::isfinite(uv.y);
           });
}

inline bool has_indices_in_range(const PolygonSoup& soup) {
    const auto holds = [](const auto& values, std::uint32_t index) {
        return index == PolygonSoup::none || index < values.size();
    };
    return std::ranges::all_of(soup.corners, [&](const PolygonSoup::Corner& corner) {
        return corner.position < soup.positions.size() && holds(soup.normals, corner.normal) &&
               holds(soup.uvs, corner.uv);
    });
}

/// Which promise of PolygonSoup this one breaks; empty if none.
inline std::string broken_promise(const PolygonSoup& soup) {
    if (!has_only_finite_numbers(soup)) return "a number is not finite";
    if (!has_indices_in_range(soup)) return "an index is out of range";
    if (soup.face_begin.empty() || soup.face_begin.front() != 0) return "faces start elsewhere";
    if (!std::ranges::is_sorted(soup.face_begin)) return "face_begin descends";
    if (soup.face_begin.back() != soup.corners.size()) return "corners are left over";
    if (!soup.colors.empty() && soup.colors.size() != soup.positions.size())
        return "colors missing";
    if (!soup.face_material.empty() && soup.face_material.size() != soup.face_count()) {
        return "face materials missing";
    }
    const auto known = [&](std::uint32_t index) { return index < soup.materials.size(); };
    if (!std::ranges::all_of(soup.face_material, known)) return "a material is out of range";
    return {};
}

/// Bytes that the soup's arrays take.
inline std::size_t bytes_of(const PolygonSoup& soup) {
    const auto bytes = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
    return bytes(soup.positions) + bytes(soup.colors) + bytes(soup.normals) + bytes(soup.uvs) +
           bytes(soup.corners) + bytes(soup.face_begin) + bytes(soup.face_material) +
           bytes(soup.materials);
}

/// What reading a file of this size may take.
inline std::size_t memory_bound(std::size_t file_bytes) {
    return 64 * file_bytes + (std::size_t{64} << 20);
}

}  // namespace scanlight::mesh
