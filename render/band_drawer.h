#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "raster/visible_band.h"
#include "render/draw_polygons.h"
#include "render/lane_path.h"
#include "render/layers.h"
#include "render/object_pass.h"
#include "render/shadow_map.h"
#include "render/walker.h"

namespace scanlight::render {

/// Draws one band of rows after the other, for one thread: finds out what each pixel shows, then
/// gives it its light. Keeps its memory from one band, and one picture, to the next.
class BandDrawer {
public:
    /// What all bands share.
    struct Picture {
        const LanePath& path;
        std::span<const ObjectPass> passes;
        std::span<const ObjectPass> transparent;  // over them; then the target is of floats
        const Frame& frame;
        std::span<const ShadowMap> maps;  // of all lights, where shadows are theirs
        const Settings& settings;
        raster::Rgba background;
        const Target& target;
        std::optional<raster::Encoding> at_once;  // see `light_at_once`
        raster::Plane<raster::Depth>* depth;      // may be null
        std::span<Stencil> stencils;              // one a light, or none

        /// How many numbers a pixel keeps, beside its depth.
        int kept() const;
    };

    /// A picture begins: nothing is counted yet.
    void begin();

    /// The `number`-th band, which has these rows; where the settings ask for more than one sample
    /// a pixel, rows and width are those of samples, and no depth is copied.
    void draw(const Picture& picture, int width, raster::Rows rows, int number);

    void add_to(DrawCounts& counts) const;
    std::size_t bytes() const {
        return band_.bytes() + shadows_.bytes() + raster::bytes_held(items_, blends_, means_) +
               samples_.values().size_bytes();
    }

private:
    void draw_samples(const Picture& picture, int width, raster::Rows rows, int number);
    void draw_pixels(const Picture& picture, int width, raster::Rows rows, int number);
    void store_means(raster::Rows rows, int grid, const Target& target);
    void draw_lit(const Picture& picture, int number);
    void draw_then_light(const Picture& picture, int number);
    void find_shadows(const Picture& picture, int number, std::span<Stencil> stencils);
    std::size_t see(const Picture& picture, const ObjectPass& pass, int number);
    void draw_surroundings(const Picture& picture);
    void draw_layers(const Picture& picture, int number);
    bool see_layer(const Picture& picture, int number);
    void add_layer(const Picture& picture, const ObjectPass& pass);
    void add_layer_row(const ObjectPass& pass, int y);
    void lay_over(const FloatTarget& target) const;
    Blend* blends(int y);
    std::span<const raster::FaceItem> lit_sides(Sides sides,
                                                std::span<const raster::FaceItem> items);
    void copy_depth(raster::Plane<raster::Depth>& to);

    raster::VisibleBand band_;
    ShadowBand shadows_;
    raster::Plane<raster::Rgba> samples_;  // of the band, where a pixel has more than one
    std::vector<raster::Rgba> means_;      // of a row of pixels
    WalkMemories walks_;
    std::vector<raster::FaceItem> items_;
    std::vector<const ObjectPass*> seen_;
    LayerRow layer_row_;
    std::vector<Blend> blends_;  // of the band's pixels
    std::size_t shaded_ = 0;
};

}  // namespace scanlight::render
