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
    const bool at_once = lights_at_once(picture.settings, picture.target);
    int kept = 1;
    for (const ObjectPass& pass : picture.passes)
        kept = std::max(kept, at_once ? 1 : 1 + pass.attributes.count);
    band_.clear(width, rows, kept);
    at_once ? draw_lit(picture, number) : draw_then_light(picture, number);
    if (picture.depth != nullptr) copy_depth(*picture.depth);
}

void BandDrawer::draw_lit(const Picture& picture, int number) {
    for (const ObjectPass& pass : picture.passes)
        shaded_ += see(picture, pass, number);
    picture.path.store_band(band_, picture.target);
}

/// First all objects are seen, so that nothing is lit that another hides.
void BandDrawer::draw_then_light(const Picture& picture, int number) {
    band_.forget_items();
    seen_.clear();
    for (const ObjectPass& pass : picture.passes) {
        if (see(picture, pass, number) > 0) seen_.push_back(&pass);
    }
    if (seen_.empty()) return fill_rows(picture.target, band_.rows());
    const bool has_shadows = picture.settings.shadows != Shadows::none;
    if (has_shadows) shadows_.find(picture.passes, band_, number);
    Background background = Background::drawn;
    for (const ObjectPass* pass : seen_) {
        shaded_ += picture.path.light_band(*pass, band_, has_shadows ? &shadows_ : nullptr, row_,
                                           picture.target, background);
        background = Background::kept;
    }
}

/// Finds out what each pixel shows; how many come to show this object, some more than once.
std::size_t BandDrawer::see(const Picture& picture, const ObjectPass& pass, int number) {
    const std::size_t before = band_.counts().passed;
    Walker walker(pass, walks_, band_.rows());
    for (const raster::Bin& bin : pass.bins) {
        picture.path.see(pass, lit_sides(picture.settings.sides, bin.band(number)), picture.target,
                         band_, walker);
    }
    return band_.counts().passed - before;
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
