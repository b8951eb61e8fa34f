#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "apps/exercises/exercise.h"
#include "raster/fill.h"

#include <your_part.h>  // of the folder that the build names

namespace scanlight::exercises {

namespace {

constexpr int width = 96;
constexpr int height = 72;

using Points = std::vector<glm::dvec2>;

/// A star, in pixels; all its coordinates are whole multiples of 1/256.
Points star() {
    return {{47.75, 3.25},  {58.125, 25.0}, {90.5, 24.375}, {64.25, 42.75}, {75.875, 69.5},
            {48.0, 52.125}, {19.25, 68.75}, {31.5, 41.875}, {4.375, 23.5},  {37.25, 24.75}};
}

void fill(int y, double x_begin, double x_end, raster::Image8& image) {
    const int begin = std::max(0, static_cast<int>(std::ceil(x_begin - 0.5)));
    const int end = std::min(width, static_cast<int>(std::ceil(x_end - 0.5)));
    for (int x = begin; x < end && y >= 0 && y < height; ++x)
        image.pixel(x, y)[0] = 230;
}

/// The table of all edges that are not horizontal.
std::vector<ActiveEdge> edges_of(const Points& polygon) {
    std::vector<ActiveEdge> edges;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        glm::dvec2 a = polygon[i];
        glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        if (a.y > b.y) std::swap(a, b);
        if (a.y < b.y) edges.push_back(active_edge(a.x, a.y, b.x, b.y));
    }
    return edges;
}

/// Fills between each pair of crossings of a row.
void fill_row(int y, std::vector<ActiveEdge>& edges, raster::Image8& image) {
    std::vector<double> crossings;
    for (ActiveEdge& edge : edges) {
        if (y < edge.y_begin || y >= edge.y_end) continue;
        crossings.push_back(edge.x);
        step(edge);
    }
    std::ranges::sort(crossings);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        fill(y, crossings[i], crossings[i + 1], image);
}

raster::Image8 yours() {
    raster::Image8 image(width, height, 1);
    auto edges = edges_of(star());
    for (int y = 0; y < height; ++y)
        fill_row(y, edges, image);
    return image;
}

raster::Image8 right() {
    raster::Image8 image(width, height, 1);
    std::vector<raster::ScreenVertex<0>> corners;
    for (const glm::dvec2& p : star()) {
        corners.push_back({static_cast<raster::SubPixel>(p.x * raster::subpixels),
                           static_cast<raster::SubPixel>(p.y * raster::subpixels),
                           0,
                           {}});
    }
    raster::PolygonFiller<0> filler;
    filler.fill(corners, raster::Interpolation::bilinear, [&](const raster::Span<0>& span) {
        fill(span.y, span.x_begin + 0.5, span.x_end + 0.5, image);
    });
    return image;
}

Checks checks() {
    Checks checks;
    ActiveEdge edge = active_edge(2, 1, 6, 5);
    checks.number("(2, 1) to (6, 5): y_begin", edge.y_begin, 1);
    checks.number("(2, 1) to (6, 5): y_end", edge.y_end, 5);
    checks.number("(2, 1) to (6, 5): x on the first row", edge.x, 2.5);
    checks.number("(2, 1) to (6, 5): dx_dy", edge.dx_dy, 1);
    step(edge);
    checks.number("(2, 1) to (6, 5): x on the second row", edge.x, 3.5);
    const ActiveEdge steep = active_edge(8, 0.75, 5, 4.5);
    checks.number("(8, 0.75) to (5, 4.5): y_begin, below the first centre line", steep.y_begin, 1);
    checks.number("(8, 0.75) to (5, 4.5): y_end, on a centre line", steep.y_end, 4);
    checks.number("(8, 0.75) to (5, 4.5): x on the first row", steep.x, 7.4);
    checks.number("(8, 0.75) to (5, 4.5): dx_dy", steep.dx_dy, -0.8);
    const ActiveEdge none = active_edge(0, 1.6, 9, 2.4);
    checks.number("(0, 1.6) to (9, 2.4), between two centre lines: rows", none.y_end - none.y_begin,
                  0);
    return checks;
}

}  // namespace

}  // namespace scanlight::exercises

int main(int argc, char** argv) {
    using namespace scanlight::exercises;
    return judge({"active_edge", checks, yours, right}, argc, argv);
}
