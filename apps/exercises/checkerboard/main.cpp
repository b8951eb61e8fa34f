#include <algorithm>

#include "apps/exercises/exercise.h"
#include "shading/pattern.h"
#include "shading/sampling.h"

#include <your_part.h>  // of the folder that the build names

namespace scanlight::exercises {

namespace {

constexpr int side = 96;
constexpr int count = 6;

/// Of a pixel's centre: from -1 to 2 over the picture.
double coordinate(int pixel) {
    return -1.0 + 3.0 * (pixel + 0.5) / side;
}

template <class IsDark>
raster::Image8 board(IsDark&& is_dark) {
    raster::Image8 image(side, side, 1);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x)
            image.pixel(x, y)[0] = is_dark(coordinate(x), coordinate(y)) ? 60 : 220;
    }
    return image;
}

raster::Image8 yours() {
    return board([](double u, double v) { return is_dark(u, v, count); });
}

raster::Image8 right() {
    using shading::Wrap;
    return board([](double u, double v) {
        return shading::checkerboard(shading::wrapped(u, Wrap::repeat),
                                     shading::wrapped(v, Wrap::repeat), double{count}) == 0.0;
    });
}

Checks checks() {
    Checks checks;
    checks.answer("dark at (0.01, 0.01), of 8 squares", is_dark(0.01, 0.01, 8), false);
    checks.answer("dark at (0.2, 0.01)", is_dark(0.2, 0.01, 8), true);
    checks.answer("dark at (0.2, 0.2)", is_dark(0.2, 0.2, 8), false);
    checks.answer("dark at (1.01, 0.01)", is_dark(1.01, 0.01, 8), false);
    checks.answer("dark at (-0.01, 0.01)", is_dark(-0.01, 0.01, 8), true);
    checks.answer("dark at (-0.01, -0.01)", is_dark(-0.01, -0.01, 8), false);
    checks.answer("dark at (-0.2, 0.2)", is_dark(-0.2, 0.2, 8), true);
    return checks;
}

}  // namespace

}  // namespace scanlight::exercises

int main(int argc, char** argv) {
    using namespace scanlight::exercises;
    return judge({"checkerboard", checks, yours, right}, argc, argv);
}
