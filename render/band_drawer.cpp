#include "render/band_drawer.h"

#include <algorithm>

#include "raster/box_filter.h"
#include "render/opacity.h"
#include "render/surroundings.h"

namespace scanlight::render {

namespace {

void fill_rows(const Target& target, raster::Rows rows) {
    std::visit(
        [&](const auto& t) {
            for (int y = rows.y_begin; y < rows.y_end; ++y)
                std::ranges::fill(t.row(y), t.background);
        },
        target);
}

void put(const raster::Rgba& color, const Target& target, int x, int y) {
    if (const auto* floats = std::get_if<FloatTarget>(&target)) {
        floats->row(y)[static_cast<std::size_t>(x)] = color;
    } else {
        const auto& packed = std::get<PackedTarget>(target);
        packed.row(y)[static_cast<std::size_t>(x)] = raster::packed_pixel(color, packed.encoding);
    }
}

}  // namespace

int BandDrawer::Picture::kept() const {
    int most = 1;
    for (const ObjectPass& pass : passes)
        most = std::max(most, at_once ? 1 : 1 + pass.attributes.count);
    for (const ObjectPass& pass : transparent)
        most = std::max(most, 3 + pass.attributes.count);
    return most;
}

void BandDrawer::begin() {
    band_.counts() = {};
    shaded_ = 0;
}

void BandDrawer::draw(const Picture& picture, int width, raster::Rows rows, int number) {
    if (picture.settings.grid > 1) {
        draw_samples(picture, width, rows, number);
    } else {
        draw_pixels(picture, width, rows, number);
    }
}

/// A band at a time, so that the samples of the whole picture need no memory.
void BandDrawer::draw_samples(const Picture& picture, int width, raster::Rows rows, int number) {
    constexpr int most_rows = 1 << raster::Bands{}.row_bits;
    if (samples_.width() != width) samples_ = raster::Plane<raster::Rgba>({width, most_rows}, {});
    const Target samples = FloatTarget{&samples_, picture.background, rows.y_begin};
    draw_pixels({picture.path,
                 picture.passes,
                 picture.transparent,
                 picture.frame,
                 picture.maps,
                 picture.settings,
                 picture.background,
                 samples,
                 {},
                 {},
                 {}},
                width, rows, number);
    store_means(rows, picture.settings.grid, picture.target);
}

void BandDrawer::store_means(raster::Rows rows, int grid, const Target& target) {
    for (int y = rows.y_begin; y < rows.y_end; y += grid) {
        means_.resize(static_cast<std::size_t>(samples_.width() / grid));
        raster::average_rows(samples_, y - rows.y_begin, means_);
        store_colors(means_, y / grid, target);
    }
}

void BandDrawer::draw_pixels(const Picture& picture, int width, raster::Rows rows, int number) {
    band_.clear(width, rows, picture.kept());
    picture.at_once ? draw_lit(picture, number) : draw_then_light(picture, number);
    if (picture.depth != nullptr) copy_depth(*picture.depth);
    if (picture.frame.surroundings != nullptr) draw_surroundings(picture);
    if (!picture.transparent.empty()) draw_layers(picture, number);
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
    const bool has_shadows = picture.settings.shadows != Shadows::none;
    if (has_shadows && (!seen_.empty() || !picture.stencils.empty()))
        find_shadows(picture, number, picture.stencils);
    if (seen_.empty()) return fill_rows(picture.target, band_.rows());
    Background background = Background::drawn;
    for (const ObjectPass* pass : seen_) {
        shaded_ += picture.path.light_band(*pass, band_, has_shadows ? &shadows_ : nullptr,
                                           picture.target, background);
        background = Background::kept;
    }
}

void BandDrawer::find_shadows(const Picture& picture, int number, std::span<Stencil> stencils) {
    if (counts_volumes(picture.settings.shadows)) {
        shadows_.find(picture.passes, band_, number, stencils);
    } else {
        shadows_.find(picture.maps, picture.frame, band_);
    }
}

/// Finds out what each pixel shows; how many come to show this object, some more than once.
std::size_t BandDrawer::see(const Picture& picture, const ObjectPass& pass, int number) {
    const std::size_t before = band_.counts().passed;
    Walker walker(pass, walks_, band_.rows());
    for (const raster::Bin& bin : pass.bins) {
        picture.path.see(pass, lit_sides(pass.settings.sides, bin.band(number)), picture.at_once,
                         band_, walker);
    }
    return band_.counts().passed - before;
}

/// Where nothing else is.
void BandDrawer::draw_surroundings(const Picture& picture) {
    for (int y = band_.rows().y_begin; y < band_.rows().y_end; ++y) {
        const raster::Depth* depth = band_.depth_row(y);
        for (int x = 0; x < band_.width(); ++x) {
            if (depth[x] == raster::depth_clear)
                put(surroundings_at(picture.frame, x, y), picture.target, x, y);
        }
    }
}

/// See layers.h.
void BandDrawer::draw_layers(const Picture& picture, int number) {
    blends_.assign(band_.pixels(), {});
    layer_row_.resize(static_cast<std::size_t>(band_.width()) + raster::most_lanes);
    band_.begin_layers();
    for (int i = 0; i < most_layers && see_layer(picture, number); ++i) {
        if (picture.settings.shadows != Shadows::none) find_shadows(picture, number, {});
        for (const ObjectPass* pass : seen_)
            add_layer(picture, *pass);
        band_.next_layer();
    }
    lay_over(std::get<FloatTarget>(picture.target));
}

/// The next layer; false if there is nothing in it.
bool BandDrawer::see_layer(const Picture& picture, int number) {
    seen_.clear();
    for (const ObjectPass& pass : picture.transparent) {
        const std::size_t before = band_.counts().passed;
        Walker walker(pass, walks_, band_.rows());
        for (const raster::Bin& bin : pass.bins) {
            picture.path.see_behind(pass, lit_sides(pass.settings.sides, bin.band(number)), band_,
                                    walker);
        }
        if (band_.counts().passed > before) seen_.push_back(&pass);
    }
    return !seen_.empty();
}

void BandDrawer::add_layer(const Picture& picture, const ObjectPass& pass) {
    const bool has_shadows = picture.settings.shadows != Shadows::none;
    for (int y = band_.rows().y_begin; y < band_.rows().y_end; ++y) {
        picture.path.light_layer_row(pass, band_, has_shadows ? &shadows_ : nullptr, y, layer_row_);
        add_layer_row(pass, y);
    }
}

void BandDrawer::add_layer_row(const ObjectPass& pass, int y) {
    const std::int32_t* items = band_.kept_row(0, y);
    const VectorStreams& color = layer_row_.color;
    Blend* blend = blends(y);
    for (std::size_t x = 0; x < static_cast<std::size_t>(band_.width()); ++x) {
        if (!pass.faces.holds(items[x])) continue;
        blend[x].add({color.x[x], color.y[x], color.z[x]}, layer_row_.opacity[x],
                     filter_of(*pass.object, pass.faces.face(items[x])));
        ++shaded_;
    }
}

Blend* BandDrawer::blends(int y) {
    return blends_.data() + static_cast<std::size_t>(y - band_.rows().y_begin) *
                                static_cast<std::size_t>(band_.width());
}

void BandDrawer::lay_over(const FloatTarget& target) const {
    const Blend* blend = blends_.data();
    for (int y = band_.rows().y_begin; y < band_.rows().y_end; ++y) {
        for (raster::Rgba& pixel : target.row(y)) {
            if (!blend->is_clear()) pixel = blend->over(pixel);
            ++blend;
        }
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
