#include <cmath>
#include <utility>
#include <vector>

#include "apps/exercises/exercise.h"
#include "raster/fill.h"

#include <your_part.h>  // of the folder that the build names

namespace scanlight::exercises {

namespace {

constexpr int width = 96;
constexpr int height = 72;

struct Corner {
    double x, y, I;
};

/// Of a triangle, from top to bottom; coordinates are whole multiples of 1/256.
constexpr Corner top{30.25, 3.5, 1.0};
constexpr Corner middle{90.75, 40.25, 0.05};
constexpr Corner bottom{8.5, 68.125, 0.45};

std::uint8_t level(double I) {
    return static_cast<std::uint8_t>(std::lround(255.0 * I));
}

/// A point of an edge on a row's centre line.
std::pair<double, double> on_edge(const Corner& a, const Corner& b, int row) {
    const double share = (row + 0.5 - a.y) / (b.y - a.y);
    return {a.x + share * (b.x - a.x), a.I + share * (b.I - a.I)};
}

void draw_row(int y, raster::Image8& image) {
    const bool is_upper = y + 0.5 < middle.y;
    const auto [x_a, I_a] = on_edge(top, bottom, y);
    const auto [x_b, I_b] = is_upper ? on_edge(top, middle, y) : on_edge(middle, bottom, y);
    Ramp span = ramp(x_a, I_a, x_b, I_b);
    for (int x = span.x_begin; x < span.x_end; ++x, step(span)) {
        if (x >= 0 && x < width) image.pixel(x, y)[0] = level(span.I);
    }
}

raster::Image8 yours() {
    raster::Image8 image(width, height, 1);
    const int end = static_cast<int>(std::ceil(bottom.y - 0.5));
    for (int y = static_cast<int>(std::ceil(top.y - 0.5)); y < end; ++y)
        draw_row(y, image);
    return image;
}

raster::Image8 right() {
    raster::Image8 image(width, height, 1);
    std::vector<raster::ScreenVertex<1>> corners;
    for (const Corner& c : {top, middle, bottom}) {
        corners.push_back({static_cast<raster::SubPixel>(c.x * raster::subpixels),
                           static_cast<raster::SubPixel>(c.y * raster::subpixels),
                           0,
                           {raster::attribute_from_float(static_cast<float>(c.I))}});
    }
    raster::PolygonFiller<1> filler;
    filler.fill(corners, raster::Interpolation::bilinear, [&](raster::Span<1> span) {
        for (int x = span.x_begin; x < span.x_end; ++x, span.ramps.step())
            image.pixel(x, span.y)[0] =
                level(raster::float_from_attribute(span.ramps.attributes[0].get()));
    });
    return image;
}

Checks checks() {
    Checks checks;
    Ramp span = ramp(2.5, 0.2, 12.5, 0.7);
    checks.number("from 0.2 at 2.5 to 0.7 at 12.5: x_begin", span.x_begin, 2);
    checks.number("from 0.2 at 2.5 to 0.7 at 12.5: x_end", span.x_end, 12);
    checks.number("from 0.2 at 2.5 to 0.7 at 12.5: I at the first pixel", span.I, 0.2);
    checks.number("from 0.2 at 2.5 to 0.7 at 12.5: dI", span.dI, 0.05);
    step(span);
    checks.number("from 0.2 at 2.5 to 0.7 at 12.5: I at the second pixel", span.I, 0.25);
    const Ramp falling = ramp(4.75, 1.0, 8.75, 0.0);
    checks.number("from 1 at 4.75 to 0 at 8.75: x_begin", falling.x_begin, 5);
    checks.number("from 1 at 4.75 to 0 at 8.75: x_end", falling.x_end, 9);
    checks.number("from 1 at 4.75 to 0 at 8.75: I at the first pixel's centre", falling.I, 0.8125);
    checks.number("from 1 at 4.75 to 0 at 8.75: dI", falling.dI, -0.25);
    return checks;
}

}  // namespace

}  // namespace scanlight::exercises

int main(int argc, char** argv) {
    using namespace scanlight::exercises;
    return judge({"gouraud_span", checks, yours, right, 1}, argc, argv);
}
