#include "apps/demo/measure.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace scanlight::demo {

double intensity(const raster::Rgba& color) {
    return (static_cast<double>(color.r) + static_cast<double>(color.g) +
            static_cast<double>(color.b)) /
           3.0;
}

std::vector<double> intensities(const raster::Plane<raster::Rgba>& light, int y) {
    std::vector<double> values;
    for (const raster::Rgba& color : light.row(y))
        values.push_back(intensity(color));
    return values;
}

Stretch surface_of_row(const raster::Plane<raster::Depth>& depth, int y) {
    Stretch stretch;
    for (int x = 0; x < depth.width(); ++x) {
        if (depth.at(x, y) >= raster::depth_clear) continue;
        if (stretch.end == 0) stretch.begin = x;
        stretch.end = x + 1;
    }
    return stretch;
}

Pixel brightest(const raster::Framebuffer& picture) {
    Pixel best;
    double most = -1.0;
    for (int y = 0; y < picture.color.height(); ++y) {
        for (int x = 0; x < picture.color.width(); ++x) {
            const double value = intensity(picture.color.at(x, y));
            if (value <= most || picture.depth.at(x, y) >= raster::depth_clear) continue;
            most = value;
            best = {x, y};
        }
    }
    return best;
}

Pixel nearest_surface(const raster::Plane<raster::Depth>& depth, const Pixel& to) {
    Pixel best = to;
    int least = std::numeric_limits<int>::max();
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const int far = (x - to.x) * (x - to.x) + (y - to.y) * (y - to.y);
            if (far >= least || depth.at(x, y) >= raster::depth_clear) continue;
            least = far;
            best = {x, y};
        }
    }
    return best;
}

std::vector<glm::dvec2> points_of(const std::vector<double>& values, const Stretch& stretch) {
    std::vector<glm::dvec2> points;
    for (int x = stretch.begin; x < stretch.end; ++x)
        points.emplace_back(x + 0.5, values[static_cast<std::size_t>(x)]);
    return points;
}

std::vector<glm::dvec2> surface_points(const raster::Framebuffer& picture, int y) {
    auto points = points_of(intensities(picture.color, y), surface_of_row(picture.depth, y));
    for (glm::dvec2& point : points) {
        if (picture.depth.at(static_cast<int>(point.x), y) >= raster::depth_clear)
            point.y = std::numeric_limits<double>::quiet_NaN();
    }
    return points;
}

Mark mark_at(const Pixel& pixel) {
    const glm::dvec2 centre(pixel.x + 0.5, pixel.y + 0.5);
    return {centre, centre};
}

Mark mark_along(int y, int width) {
    return {{0.5, y + 0.5}, {width - 0.5, y + 0.5}};
}

}  // namespace scanlight::demo
