#include "raster/lane_path.h"
#include "raster/lanes/cull.h"
#include "raster/lanes/large_triangle.h"
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
        prepare(streams_, triangles_at(streams_, faces_of(items)), band_.rows(), prepared);
        const std::uint32_t triangles = triangles_among(items);
        const std::uint32_t tiny = prepared.tiny & triangles;
        const std::uint32_t small = prepared.small & prepared.planar & triangles;
        std::uint32_t left = bits_of(first_lanes(static_cast<int>(items.size())));
        for (left &= ~(prepared.unseen & triangles); left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            const FaceItem face = items[static_cast<std::size_t>(lane)];
            if ((tiny >> lane & 1) != 0) {
                draw_tiny(prepared, lane, face);
            } else if ((small >> lane & 1) != 0) {
                draw_small(prepared, lane, face);
            } else if ((prepared.planar & triangles) >> lane & 1) {
                draw_large(prepared, lane, face);
            } else {
                walker_.draw(face);
            }
        }
    }

    /// A bit a lane: which are not to be walked.
    static std::uint32_t triangles_among(std::span<const FaceItem> items) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < items.size(); ++i)
            bits |= ((items[i] & walk_flag) == 0 ? 1u : 0u) << i;
        return bits;
    }

    /// Lanes without an item repeat the first.
    static Ints faces_of(std::span<const FaceItem> items) {
        std::int32_t faces[lane_count];
        for (std::size_t i = 0; i < lane_count; ++i)
            faces[i] = static_cast<std::int32_t>(items[i < items.size() ? i : 0] & face_mask);
        return load(faces);
    }

    void draw_tiny(const PreparedTriangles& prepared, int lane, FaceItem face) {
        note(prepared, lane, face, HWY_NAMESPACE::draw_tiny(prepared, lane, next_record(), band_));
    }
    void draw_small(const PreparedTriangles& prepared, int lane, FaceItem face) {
        note(prepared, lane, face, SmallTriangle(prepared, lane, next_record(), band_).draw());
    }

    void draw_large(const PreparedTriangles& prepared, int lane, FaceItem face) {
        const auto v = streams_.face(face & face_mask);
        const auto corner = [&](std::uint32_t i) {
            return ScreenPoint{streams_.x[i], streams_.y[i]};
        };
        LargeTriangle triangle(prepared, lane, {corner(v[0]), corner(v[1]), corner(v[2])},
                               next_record(), band_);
        note(prepared, lane, face, triangle.draw());
    }

    Item next_record() const { return static_cast<Item>(records_.count); }

    /// The next record is written in any case; it counts only if the triangle is seen somewhere.
    void note(const PreparedTriangles& prepared, int lane, FaceItem face, PixelCounts pixels) {
        band_.touch(prepared.x_begin[lane], prepared.x_end[lane]);
        band_.counts() += pixels;
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
