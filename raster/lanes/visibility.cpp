#include "raster/lane_path.h"
#include "raster/lanes/cull.h"
#include "raster/lanes/triangles.h"

namespace scanlight::raster::HWY_NAMESPACE {

namespace {

void cull_faces(const PolygonStreams& streams, CullRule rule, std::size_t begin, std::size_t end,
                Survivors& survivors, FateCounts& counts) {
    TriangleCuller(streams, rule).cull(begin, end, survivors, counts);
}

/// Draws polygons into one band, in their order.
class BandPainter {
public:
    BandPainter(const PolygonStreams& streams, VisibleBand& band, AttributeRecords& records,
                Walker& walker)
        : streams_(streams), band_(band), records_(records), walker_(walker) {}

    void draw(std::span<const FaceItem> items) {
        for (std::size_t i = 0; i < items.size(); i += lane_count) {
            const std::size_t n = std::min<std::size_t>(lane_count, items.size() - i);
            records_.reserve(records_.count + n);
            draw_vector(items.subspan(i, n));
        }
    }

private:
    SCANLIGHT_FLATTEN void draw_vector(std::span<const FaceItem> items) {
        PreparedTriangles prepared;
        prepare(streams_, triangles_at(streams_, faces_of(items)), prepared);
        for (std::size_t i = 0; i < items.size(); ++i) {
            const auto lane = static_cast<int>(i);
            const bool is_triangle = (items[i] & walk_flag) == 0;
            const bool has_plane = is_triangle && (prepared.planar >> lane & 1) != 0;
            const bool is_small = (prepared.small >> lane & 1) != 0;
            if (has_plane && is_small) {
                draw_small(prepared, lane, items[i]);
            } else {
                walker_.draw(items[i], has_plane);
            }
        }
    }

    /// Lanes without an item repeat the first.
    static Ints faces_of(std::span<const FaceItem> items) {
        std::int32_t faces[lane_count];
        for (std::size_t i = 0; i < lane_count; ++i)
            faces[i] = static_cast<std::int32_t>(items[i < items.size() ? i : 0] & face_mask);
        return load(faces);
    }

    void draw_small(const PreparedTriangles& prepared, int lane, FaceItem face) {
        const auto record = static_cast<Item>(records_.count);
        band_.touch(prepared.x_begin[lane], prepared.x_end[lane]);
        const PixelCounts pixels = SmallTriangle(prepared, lane, record, band_).draw();
        band_.counts() += pixels;
        // Written in any case, it counts only if the triangle is seen somewhere.
        records_.face[records_.count] = static_cast<std::int32_t>(face);
        records_.count += pixels.passed > 0 ? 1 : 0;
    }

    const PolygonStreams& streams_;
    VisibleBand& band_;
    AttributeRecords& records_;
    Walker& walker_;
};

void draw_items(const PolygonStreams& streams, std::span<const FaceItem> items, VisibleBand& band,
                AttributeRecords& records, Walker& walker) {
    BandPainter(streams, band, records, walker).draw(items);
}

SCANLIGHT_FLATTEN std::size_t draw_one_span(Depth* depth, Item* items, int x_begin, int x_end,
                                            const Ramp& ramp, Item item) {
    return draw_span(depth, items, x_begin, x_end, ramp, item);
}

}  // namespace

extern const LanePath lane_path;
const LanePath lane_path{hwy::TargetName(HWY_TARGET), lane_count, cull_faces, draw_items,
                         draw_one_span};

}  // namespace scanlight::raster::HWY_NAMESPACE
