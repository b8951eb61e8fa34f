#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace scanlight::mesh {

/// Newell's area vector of a polygon: along its normal, as long as its area. Computed in double and
/// relative to a corner, so that a small polygon far from the origin keeps its direction.
/// Sutherland, Sproull & Schumacker 1974, "A characterization of ten hidden-surface algorithms"
/// (they credit M. E. Newell).
///
/// A polygon that crosses itself so that its areas cancel (a bow tie) gets its largest triangle of
/// the fan about the first corner. Zero only when no such triangle has an area beyond the rounding
/// error of computing it.
glm::dvec3 area_vector(std::span<const glm::vec3> polygon);

/// v at unit length; zero stays zero.
glm::dvec3 unit_or_zero(const glm::dvec3& v);

}  // namespace scanlight::mesh
