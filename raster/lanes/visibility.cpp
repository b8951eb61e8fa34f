#include "raster/lane_path.h"
#include "raster/lanes/cull.h"
#include "raster/lanes/triangles.h"

namespace scanlight::raster::HWY_NAMESPACE {

namespace {

void cull_faces(const PolygonStreams& streams, CullRule rule, std::size_t begin, std::size_t end,
                Survivors& survivors, FateCounts& counts) {
    TriangleCuller(streams, rule).cull(begin, end, survivors, counts);
}

/// Draws the polygons of one bin into one band, in their order.
class BandPainter {
public:
    BandPainter(const PolygonStreams& streams, const Bin& bin, VisibleBand& band,
                BandScratch& scratch, PixelCounts& counts)
        : streams_(streams), bin_(bin), band_(band), scratch_(scratch), counts_(counts) {}

    void draw(std::span<FaceItem> items, Item first) {
        for (std::size_t i = 0; i < items.size(); i += lane_count) {
            const std::size_t n = std::min<std::size_t>(lane_count, items.size() - i);
            draw_vector(items.subspan(i, n), first + static_cast<Item>(i));
        }
    }

private:
    void draw_vector(std::span<FaceItem> items, Item first) {
        const Ints faces = faces_of(items);
        PreparedTriangles prepared;
        prepare(streams_, triangles_at(streams_, faces), prepared);
        for (std::size_t i = 0; i < items.size(); ++i) {
            draw_one(prepared, static_cast<int>(i), items[i], first + static_cast<Item>(i));
        }
    }

    /// Lanes without an item repeat the first.
    static Ints faces_of(std::span<const FaceItem> items) {
        std::int32_t faces[lane_count];
        for (std::size_t i = 0; i < lane_count; ++i)
            faces[i] = static_cast<std::int32_t>(items[i < items.size() ? i : 0] & face_mask);
        return load(faces);
    }

    void draw_one(const PreparedTriangles& prepared, int lane, FaceItem& face, Item item) {
        const bool is_planar = (prepared.planar >> lane & 1) != 0;
        const bool is_small = (prepared.small >> lane & 1) != 0;
        if ((face & walk_flag) == 0 && !is_planar) face |= walk_flag;
        if ((face & walk_flag) == 0 && is_small) {
            SmallTriangle(prepared, lane, item, band_).draw(counts_);
        } else {
            walk(face & face_mask, item);
        }
    }

    void walk(std::size_t face, Item item) {
        const auto emit = [&](const Span<0>& span) {
            ++counts_.spans;
            counts_.tested += static_cast<std::size_t>(span.x_end - span.x_begin);
            counts_.passed += draw_span(band_.depth_row(span.y), band_.item_row(span.y),
                                        span.x_begin, span.x_end, span.ramps.depth, item);
        };
        scratch_.filler.fill(corners_of(face), Interpolation::planar, emit, NoObserver{},
                             band_.rows());
    }

    std::span<const ScreenVertex<0>> corners_of(std::size_t face) {
        const auto clipped = bin_.clipped(face);
        if (!clipped.empty()) return clipped;
        scratch_.corners.clear();
        for (const std::uint32_t v : streams_.face(face))
            scratch_.corners.push_back(streams_.corner(v));
        return scratch_.corners;
    }

    const PolygonStreams& streams_;
    const Bin& bin_;
    VisibleBand& band_;
    BandScratch& scratch_;
    PixelCounts& counts_;
};

void draw_items(const PolygonStreams& streams, const Bin& bin, std::span<FaceItem> items,
                Item first, VisibleBand& band, BandScratch& scratch, PixelCounts& counts) {
    BandPainter(streams, bin, band, scratch, counts).draw(items, first);
}

}  // namespace

extern const LanePath lane_path;
const LanePath lane_path{hwy::TargetName(HWY_TARGET), lane_count, cull_faces, draw_items};

}  // namespace scanlight::raster::HWY_NAMESPACE
