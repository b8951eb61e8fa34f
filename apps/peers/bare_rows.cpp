#include "apps/peers/bare_rows.h"

#include "apps/peers/bare_loop.h"

namespace scanlight::peers {

namespace {

raster::Depth depth_of(int span) {
    return raster::depth_far - 4096 * (span + 1);
}

raster::Ramp ramp(std::int64_t whole, std::int64_t step) {
    return {whole << raster::ramp_bits, step};
}

/// Stands for a polygon that covers the row many times.
struct AllSpans : raster::Walker {
    int length;

    explicit AllSpans(int pixels) : length(pixels) {}
    void draw(raster::FaceItem, const raster::CornerAttributes*,
              raster::SpanPainter& painter) override {
        constexpr std::int64_t half = 1 << 28;
        const raster::Ramp attributes[] = {ramp(half, 1000), ramp(half, -1000), ramp(half, 500),
                                           ramp(2 * half, 0)};
        for (int i = 0; i < BareRows::spans; ++i)
            painter.draw_span(0, 0, length, ramp(depth_of(i), 1000), attributes);
    }
};

constexpr raster::FaceItem only_face = raster::walk_flag;

}  // namespace

BareRows::BareRows(int length) : length_(length), zeros_(3), corners_{0, 1, 2}, begins_{0, 3} {
    pass_.settings.shading = render::Shading::gouraud;
    pass_.polygons = {zeros_, zeros_, zeros_, zeros_, corners_, begins_};
    pass_.attributes.count = 4;
    clear();
}

void BareRows::clear() {
    band_.clear(length_, {0, 1}, 1);
    band_.touch(0, length_);
}

void BareRows::draw_bare() {
    clear();
    for (int i = 0; i < spans; ++i) {
        bare_span(band_.depth_row(0), reinterpret_cast<raster::PackedPixel*>(band_.kept_row(0, 0)),
                  static_cast<std::size_t>(length_), depth_of(i),
                  static_cast<raster::PackedPixel>(i));
    }
}

void BareRows::draw_items(const render::LanePath& path) {
    clear();
    AllSpans walker(length_);
    path.raster->draw_items(pass_.polygons, {&only_face, 1}, 0, band_, walker);
}

void BareRows::draw_gouraud(const render::LanePath& path) {
    clear();
    AllSpans walker(length_);
    path.see(pass_, {&only_face, 1}, raster::Encoding::linear, band_, walker);
}

}  // namespace scanlight::peers
