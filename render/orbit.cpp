#include "render/orbit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "mesh/trigonometry.h"

namespace scanlight::render {

namespace {

constexpr double margin = 1.06;  // as in framing.cpp

/// Rodrigues 1840; `axis` is unit.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double c = mesh::cosine(angle);
    const double s = mesh::sine(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1.0 - c));
}

double slope_at(std::span<const double> times, std::span<const double> values, std::size_t i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, times.size() - 1);
    const double time = times[after] - times[before];
    return time > 0.0 ? (values[after] - values[before]) / time : 0.0;
}

}  // namespace

Camera orbited(Camera camera, double angle_deg) {
    const double size = std::sqrt(glm::dot(camera.up, camera.up));
    if (size == 0.0) return camera;
    const glm::dvec3 arm =
        turned(camera.eye - camera.target, camera.up / size, angle_deg * mesh::pi / 180.0);
    camera.eye = camera.target + arm;
    return camera;
}

// A point at the angle f of its ring lies at x = r sin f, up = h cos e - r cos f sin e, and nearer
// by z = r cos f cos e + h sin e than the target. It is in the picture if slope |x or up| <= d - z;
// the largest d over all f is the amplitude of a sine.
double distance_for_orbit(const Camera& camera, std::span<const Ring> rings, double elevation_deg,
                          double aspect) {
    const double c = mesh::cosine(elevation_deg * mesh::pi / 180.0);
    const double s = mesh::sine(elevation_deg * mesh::pi / 180.0);
    const double slope_up = margin * camera.magnification;
    const double slope_x = slope_up / aspect;
    const double nearer = camera.projection == Projection::perspective ? 1.0 : 0.0;
    double distance = 0.0;
    for (const auto& [r, h] : rings) {
        const double z = nearer * h * s;
        const double aside = r * std::sqrt(slope_x * slope_x + nearer * c * c) + z;
        const double above = r * std::abs(nearer * c - slope_up * s) + slope_up * h * c + z;
        const double below = r * std::abs(nearer * c + slope_up * s) - slope_up * h * c + z;
        distance = std::max({distance, aside, above, below});
    }
    return distance;
}

double smoothly(std::span<const double> times, std::span<const double> values, double time) {
    const auto next =
        static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
    if (next == 0) return values.front();
    if (next == times.size()) return values.back();
    const std::size_t i = next - 1;
    const double length = times[next] - times[i];
    const double t = (time - times[i]) / length;
    const double rest = 1.0 - t;
    return values[i] + t * t * (3.0 - 2.0 * t) * (values[next] - values[i]) +
           t * rest * length *
               (rest * slope_at(times, values, i) - t * slope_at(times, values, next));
}

}  // namespace scanlight::render
