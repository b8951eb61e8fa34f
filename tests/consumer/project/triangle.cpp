// One room alone: a triangle into pixels.

#include <raster/fill.h>

#include <array>
#include <cstdio>

using namespace scanlight::raster;

int main() {
    constexpr SubPixel side = 8 * subpixels;
    const std::array<ScreenVertex<0>, 3> triangle{
        {{0, 0, 0, {}}, {0, side, 0, {}}, {side, side, 0, {}}}};
    int pixels = 0;
    PolygonFiller<0> filler;
    filler.fill(triangle, Interpolation::planar,
                [&](const Span<0>& span) { pixels += span.x_end - span.x_begin; });
    if (pixels != 28) std::printf("28 pixels have their centre inside, not %d\n", pixels);
    return pixels == 28 ? 0 : 1;
}
