#include "apps/demo/screen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/scanlight/label.h"

namespace scanlight::demo {

namespace {

constexpr apps::Color8 mark_color{220, 30, 60};
constexpr int circle_radius = 4;

void paste(raster::Image8& sheet, const raster::Image8& panel, int left) {
    for (int y = 0; y < panel.height(); ++y) {
        for (int x = 0; x < panel.width(); ++x)
            std::ranges::copy(panel.pixel(x, y), sheet.pixel(left + x, y).begin());
    }
}

/// Pixel by pixel along the longer side.
void draw_line(raster::Image8& picture, const Mark& mark) {
    const glm::dvec2 way = mark.to - mark.from;
    const int steps = static_cast<int>(std::ceil(std::max(std::abs(way.x), std::abs(way.y))));
    for (int i = 0; i <= steps; ++i) {
        // Multiplied first: then whole steps stay whole, and no pixel is left out.
        const glm::dvec2 at =
            mark.from + way * static_cast<double>(i) / static_cast<double>(std::max(steps, 1));
        apps::fill_box(picture, static_cast<int>(std::floor(at.x)),
                       static_cast<int>(std::floor(at.y)), 1, 1, mark_color);
    }
}

/// About a pixel, which stays to be seen.
void draw_circle(raster::Image8& picture, const glm::dvec2& at) {
    const int x = static_cast<int>(std::floor(at.x));
    const int y = static_cast<int>(std::floor(at.y));
    for (int dy = -circle_radius; dy <= circle_radius; ++dy) {
        for (int dx = -circle_radius; dx <= circle_radius; ++dx) {
            if (std::abs(std::hypot(dx, dy) - circle_radius) < 0.5)
                apps::fill_box(picture, x + dx, y + dy, 1, 1, mark_color);
        }
    }
}

}  // namespace

raster::Image8 marked(const Panel& panel) {
    raster::Image8 picture = panel.picture;
    for (const Mark& mark : panel.marks) {
        if (mark.from == mark.to) {
            draw_circle(picture, mark.from);
        } else {
            draw_line(picture, mark);
        }
    }
    return picture;
}

raster::Image8 picture_of(const Screen& screen) {
    int width = 0;
    int height = 0;
    for (const Panel& panel : screen.panels) {
        width += panel.picture.width();
        height = std::max(height, panel.picture.height());
    }
    raster::Image8 sheet(width, height, 3);
    int left = 0;
    for (const Panel& panel : screen.panels) {
        paste(sheet, marked(panel), left);
        left += panel.picture.width();
    }
    return sheet;
}

}  // namespace scanlight::demo
