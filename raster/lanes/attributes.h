#pragma once

#include "raster/attribute_records.h"
#include "raster/lanes/planes.h"
#include "raster/visible_band.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// `attribute_from_float`.
inline Ints attribute_lanes(Floats value) {
    const Floats low(-attribute_limit);
    const Floats high(attribute_limit);
    const Floats clamped = select(value >= low, select(value <= high, value, high), low);
    return nearest(clamped * Floats(attribute_one));
}

/// `float_from_attribute`.
inline Floats float_lanes(Ints attribute) {
    return floats_of(attribute) * Floats(1.0f / attribute_one);
}

/// Sets up the planes of the attributes for whole triangles, as many as there are lanes at a time.
class PlaneRecorder {
public:
    PlaneRecorder(const PolygonStreams& streams, const Attributes& attributes)
        : streams_(streams), attributes_(attributes) {}

    /// All records that are not of spans, from their faces.
    void set_up(AttributeRecords& records) const {
        if (records.attribute_count == 0) return;
        for (std::size_t i = 0; i < records.count; i += lane_count) {
            const std::size_t n = std::min<std::size_t>(lane_count, records.count - i);
            set_up_lanes(records, i, static_cast<int>(n));
        }
    }

private:
    /// Lanes beyond the n-th take face 0, and write behind the last record.
    HWY_FLATTEN void set_up_lanes(AttributeRecords& records, std::size_t i, int n) const {
        const Ints item = select(first_lanes(n), load(records.face.data() + i), Ints(0));
        const Mask planar = (item & Ints(static_cast<std::int32_t>(walk_flag))) == Ints(0);
        if (!any(planar)) return;
        const Mask back = item < Ints(0);
        const TriangleLanes v =
            triangles_at(streams_, item & Ints(static_cast<std::int32_t>(face_mask)));
        const Ints x[3] = {at(streams_.x, v.a), at(streams_.x, v.b), at(streams_.x, v.c)};
        const Ints y[3] = {at(streams_.y, v.a), at(streams_.y, v.b), at(streams_.y, v.c)};
        const PlaneSetupLanes setup = plane_setup(x, y);
        const Ints column = shift_right<subpixel_bits>(x[0]);
        const Ints row = shift_right<subpixel_bits>(y[0]);
        const Scales scales = scales_of(v);
        for (int k = 0; k < attributes_.count; ++k) {
            const auto& stream = attributes_.streams[static_cast<std::size_t>(k)];
            const AttributePlaneLanes plane = attribute_plane(
                setup, corner(stream, v.a, back, scales.a), corner(stream, v.b, back, scales.b),
                corner(stream, v.c, back, scales.c));
            write(planar, plane, column, row, records.attributes[static_cast<std::size_t>(k)], i);
        }
    }

    static Ints at(std::span<const std::int32_t> stream, Ints index) {
        return gather(stream.data(), index);
    }

    struct Scales {
        Floats a, b, c;
    };
    /// q of each corner, see `project_correct`.
    Scales scales_of(const TriangleLanes& v) const {
        if (!attributes_.perspective_correct) return {Floats(1), Floats(1), Floats(1)};
        const float* w = attributes_.w.data();
        const Floats a = gather(w, v.a);
        const Floats b = gather(w, v.b);
        const Floats c = gather(w, v.c);
        const Floats least = smaller(smaller(a, b), c);
        return {least / a, least / b, least / c};
    }
    static Floats smaller(Floats a, Floats b) { return select(b < a, b, a); }

    static Ints corner(const AttributeStream& stream, Ints vertex, Mask back, Floats scale) {
        if (stream.front == nullptr) return attribute_lanes(Floats(1) * scale);
        Floats value = gather(stream.front, vertex) * Floats(stream.front_scale);
        if (any(back)) {
            const Floats of_back = gather(stream.back, vertex) * Floats(stream.back_scale);
            value = select(back, of_back, value);
        }
        return attribute_lanes(value * scale);
    }

    static void write(Mask where, const AttributePlaneLanes& plane, Ints column, Ints row,
                      RecordStreams& streams, std::size_t i) {
        store_where(where, plane.origin - column * plane.dx - row * plane.dy,
                    streams.whole.data() + i);
        store_where(where, plane.dx, streams.dx.data() + i);
        store_where(where, plane.dy, streams.dy.data() + i);
        store_where(where, Ints(0), streams.fraction.data() + i);
        store_where(where, Ints(0), streams.fraction_dx.data() + i);
    }

    const PolygonStreams& streams_;
    const Attributes& attributes_;
};

/// The values of records at the pixels of one vector, all in one row.
class RecordReader {
public:
    RecordReader(const AttributeRecords& records, Ints record, int x, int y)
        : record_(record),
          x_(Ints(x) + iota()),
          y_(Ints(y)),
          has_fractions_(records.has_fractions),
          one_(bits_of(record == Ints(first(record))) == bits_of(first_lanes(lane_count))),
          first_(first(record)) {}

    /// Of lanes whose record is not negative.
    Floats value(const RecordStreams& streams) const {
        Ints value = read(streams.whole) + x_ * read(streams.dx) + y_ * read(streams.dy);
        if (has_fractions_) {
            value +=
                shift_right<ramp_bits>(read(streams.fraction) + x_ * read(streams.fraction_dx));
        }
        return float_lanes(value);
    }

    /// One number a record.
    Ints read(const std::vector<std::int32_t>& stream) const {
        return one_ ? Ints(stream[static_cast<std::size_t>(first_)])
                    : gather(stream.data(), record_);
    }
    Floats read(const std::vector<float>& stream) const {
        return one_ ? Floats(stream[static_cast<std::size_t>(first_)])
                    : gather(stream.data(), record_);
    }

private:
    static std::int32_t first(Ints record) { return hn::GetLane(record.v); }

    Ints record_;
    Ints x_, y_;
    bool has_fractions_;
    bool one_;  // all lanes have the same record
    std::int32_t first_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
