#include "render/band_drawer.h"

#include <algorithm>

namespace scanlight::render {

namespace {

void fill_rows(const Target& target, raster::Rows rows) {
    std::visit(
        [&](const auto& t) {
            for (int y = rows.y_begin; y < rows.y_end; ++y)
                std::ranges::fill(t.plane->row(y), t.background);
        },
        target);
}

}  // namespace

void BandDrawer::begin() {
    band_.counts() = {};
    shaded_ = 0;
}

void BandDrawer::draw(const Picture& picture, int width, raster::Rows rows, int number) {
    band_.clear(width, rows);
    Background background = Background::drawn;
    for (const ObjectPass& pass : picture.passes) {
        if (background == Background::kept) band_.forget_items();
        see(picture, pass, number);
        if (shade_.records.count == 0) continue;
        shade(picture, pass, background);
        background = Background::kept;
    }
    if (background == Background::drawn) fill_rows(picture.target, rows);
    if (picture.depth != nullptr) copy_depth(*picture.depth);
}

void BandDrawer::see(const Picture& picture, const ObjectPass& pass, int number) {
    raster::AttributeRecords& records = shade_.records;
    records.clear(pass.attributes.count);
    Walker walker(pass, *picture.path.raster, walks_, band_, records);
    for (const raster::Bin& bin : pass.bins) {
        picture.path.raster->draw_items(pass.polygons, lit_sides(picture.sides, bin.band(number)),
                                        band_, records, walker);
    }
}

/// Where only fronts are lit, they are seen from behind too.
std::span<const raster::FaceItem> BandDrawer::lit_sides(Sides sides,
                                                        std::span<const raster::FaceItem> items) {
    if (sides == Sides::two) return items;
    items_.assign(items.begin(), items.end());
    for (raster::FaceItem& item : items_)
        item &= ~raster::back_flag;
    return items_;
}

void BandDrawer::shade(const Picture& picture, const ObjectPass& pass, Background background) {
    picture.path.set_up_planes(pass, shade_.records);
    shaded_ += picture.path.shade_band(pass, band_, shade_, picture.target, background);
}

void BandDrawer::copy_depth(raster::Plane<raster::Depth>& to) {
    for (int y = band_.rows().y_begin; y < band_.rows().y_end; ++y)
        std::copy_n(band_.depth_row(y), band_.width(), to.row(y).begin());
}

void BandDrawer::add_to(DrawCounts& counts) const {
    counts.spans += band_.counts().spans;
    counts.pixels_tested += band_.counts().tested;
    counts.pixels_passed += band_.counts().passed;
    counts.pixels_shaded += shaded_;
}

}  // namespace scanlight::render
