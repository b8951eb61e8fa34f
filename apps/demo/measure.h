#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "apps/demo/stage.h"

namespace scanlight::demo {

// What is read off a picture in linear light, before it is clamped and encoded.

/// The mean of the three channels.
double intensity(const raster::Rgba& color);

/// Along a row of pixels.
std::vector<double> intensities(const raster::Plane<raster::Rgba>& light, int y);

/// Pixels from `begin` to before `end`.
struct Stretch {
    int begin = 0;
    int end = 0;
};

/// From the first to the last pixel of a row that shows a surface; empty if none does.
Stretch surface_of_row(const raster::Plane<raster::Depth>& depth, int y);

/// The brightest pixel that shows a surface, the first of several.
struct Pixel {
    int x = 0;
    int y = 0;
};
Pixel brightest(const raster::Framebuffer& picture);

/// The pixel that shows a surface nearest to another; that itself, if none does.
Pixel nearest_surface(const raster::Plane<raster::Depth>& depth, const Pixel& to);

/// The values of a stretch at their pixels' centres, as points of a curve.
std::vector<glm::dvec2> points_of(const std::vector<double>& values, const Stretch& stretch);

/// The intensities of a row at their pixels' centres; NaN, where a curve breaks off, for pixels
/// that show no surface.
std::vector<glm::dvec2> surface_points(const raster::Framebuffer& picture, int y);

/// A mark at a pixel's centre; one along a row of a picture.
Mark mark_at(const Pixel& pixel);
Mark mark_along(int y, int width);

}  // namespace scanlight::demo
