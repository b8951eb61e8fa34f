#pragma once

#include "raster/lane_path.h"
#include "raster/lanes/hidden.h"
#include "raster/lanes/large_triangle.h"
#include "raster/lanes/small_triangle.h"
#include "raster/lanes/tiny_triangle.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// Draws polygons into one band, in their order; pixels keep what `Keep` says, see keep.h.
template <class Keep>
class BandPainter final : public SpanPainter {
public:
    BandPainter(const PolygonStreams& streams, const Attributes& attributes, const Keep& keep,
                VisibleBand& band, Walker& walker)
        : streams_(streams),
          preparer_(attributes),
          keep_(keep),
          band_(band),
          walker_(walker),
          waiting_(keep_, band) {}

    void draw(std::span<const FaceItem> items) {
        for (std::size_t i = 0; i < items.size(); i += lane_count)
            draw_vector(items.subspan(i, std::min<std::size_t>(lane_count, items.size() - i)));
        waiting_.keep();
    }

    SCANLIGHT_FLATTEN void draw_span(int y, int x_begin, int x_end, const Ramp& depth,
                                     const Ramp* attributes) override {
        band_.touch(x_begin, x_end);
        const bool is_short = x_end - x_begin <= short_span;
        const std::size_t passed = is_short ? draw_short(y, x_begin, x_end, depth, attributes)
                                            : draw_long(y, x_begin, x_end, depth, attributes);
        band_.counts() += {1, static_cast<std::size_t>(x_end - x_begin), passed};
    }

private:
    SCANLIGHT_FLATTEN void draw_vector(std::span<const FaceItem> items) {
        const std::uint32_t triangles = triangles_among(items);
        const Ints lanes = lanes_of(items);
        store(keep_.own(lanes), own_);
        if (triangles != 0) prepare(lanes);
        std::uint32_t left = bits_of(first_lanes(static_cast<int>(items.size())));
        knows_corners_ = Keep::attributes > 0 && std::popcount(left & ~triangles) >= least_walked;
        if (knows_corners_) prepare_corners(lanes);
        for (left &= ~(prepared_.unseen & triangles); left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            draw_lane(lane, items[static_cast<std::size_t>(lane)]);
        }
    }

    /// By its size.
    void draw_lane(int lane, FaceItem item) {
        if (is_hidden(streams_, item & face_mask, band_)) return;
        const auto is = [lane](std::uint32_t bits) { return (bits >> lane & 1) != 0; };
        if ((item & walk_flag) != 0 || !is(prepared_.planar)) {
            draw_walked(lane, item);
        } else if (is(prepared_.tiny)) {
            draw_tiny(lane);
        } else if (is(prepared_.small)) {
            draw_small(lane);
        } else {
            draw_large(lane, item);
        }
    }

    /// Lanes without an item repeat the first.
    static Ints lanes_of(std::span<const FaceItem> items) {
        std::int32_t lanes[lane_count];
        for (std::size_t i = 0; i < lane_count; ++i)
            lanes[i] = static_cast<std::int32_t>(items[i < items.size() ? i : 0]);
        return load(lanes);
    }

    void prepare(Ints item) {
        const TriangleLanes v =
            triangles_at(streams_, item & Ints(static_cast<std::int32_t>(face_mask)));
        const TriangleSetup setup = HWY_NAMESPACE::prepare(streams_, v, band_.rows(), prepared_);
        preparer_.prepare(setup.planes, v, item < Ints(0), setup.column, setup.row, attributes_);
    }

    void prepare_corners(Ints item) {
        preparer_.prepare(streams_, item & Ints(static_cast<std::int32_t>(face_mask)),
                          item < Ints(0), corners_);
    }

    /// A bit a lane: which are not to be walked.
    static std::uint32_t triangles_among(std::span<const FaceItem> items) {
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < items.size(); ++i)
            bits |= ((items[i] & walk_flag) == 0 ? 1u : 0u) << i;
        return bits;
    }

    OneTriangle<Keep> triangle(int lane) {
        return {prepared_, lane, attributes_, keep_, own_[lane], band_};
    }

    void draw_tiny(int lane) { note(lane, HWY_NAMESPACE::draw_tiny(triangle(lane), waiting_)); }

    void draw_walked(int lane, FaceItem item) {
        const PixelCounts before = band_.counts();
        walked_ = own_[lane];
        const CornerAttributes corners = corners_[lane];
        walker_.draw(item, knows_corners_ ? &corners : nullptr, *this);
        look_behind(band_, band_.counts() - before);
    }

    // What is drawn by vectors may lie before what waits.

    void draw_small(int lane) {
        waiting_.keep();
        note(lane, SmallTriangle<Keep>(triangle(lane)).draw());
    }
    void draw_large(int lane, FaceItem item) {
        waiting_.keep();
        const auto v = streams_.face(item & face_mask);
        const auto corner = [&](std::uint32_t i) {
            return ScreenPoint{streams_.x[i], streams_.y[i]};
        };
        LargeTriangle<Keep> large(triangle(lane), {corner(v[0]), corner(v[1]), corner(v[2])});
        const PixelCounts drawn = large.draw();
        note(lane, drawn);
        look_behind(band_, drawn);
    }
    void note(int lane, PixelCounts pixels) {
        band_.touch(prepared_.x_begin[lane], prepared_.x_end[lane]);
        band_.counts() += pixels;
    }

    std::size_t draw_long(int y, int x_begin, int x_end, const Ramp& depth,
                          const Ramp* attributes) {
        waiting_.keep();
        const int before = x_begin - first_vector(x_begin, x_end);
        RampLanes z(depth, before);
        RampValues<Keep::attributes> values(attributes, before);
        return HWY_NAMESPACE::draw_span(band_.row(y), x_begin, x_end, z, values, keep_,
                                        Ints(walked_));
    }

    /// Pixel by pixel; those that pass wait.
    std::size_t draw_short(int y, int x_begin, int x_end, const Ramp& depth,
                           const Ramp* attributes) {
        waiting_.make_room(short_span);
        const PixelPlace row = band_.row(y);
        const std::ptrdiff_t row_begin = band_.stride() * (y - band_.rows().y_begin);
        std::size_t passed = 0;
        for (int x = x_begin; x < x_end; ++x) {
            const Depth z = ramp_at(depth, x - x_begin);
            if (!is_seen(z, walked_, keep_, row + x)) continue;
            row.depth[x] = z;
            waiting_.add(row_begin + x, walked_,
                         [&](int k) { return ramp_at(attributes[k], x - x_begin); });
            ++passed;
        }
        return passed;
    }

    /// Spans of no more pixels are not worth a vector's set-up.
    static constexpr int short_span = 4;
    /// For fewer polygons a vector's worth of corners is not worth its while.
    static constexpr int least_walked = 4;

    const PolygonStreams& streams_;
    AttributePreparer preparer_;
    Keep keep_;
    VisibleBand& band_;
    Walker& walker_;
    WaitingPixels<Keep> waiting_;
    PreparedTriangles prepared_;
    PreparedAttributes<Keep::attributes> attributes_;
    PreparedCorners<Keep::attributes> corners_;  // if it is known
    bool knows_corners_ = false;
    std::int32_t own_[lane_count];
    std::int32_t walked_ = 0;  // the own number of the polygon that is being walked
};

}  // namespace scanlight::raster::HWY_NAMESPACE
