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
    SCANLIGHT_FLATTEN void set_up_lanes(AttributeRecords& records, std::size_t i, int n) const {
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
            write(planar, plane, column, row, records, i, k);
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
                      AttributeRecords& records, std::size_t i, int k) {
        std::int32_t whole[lane_count], dx[lane_count], dy[lane_count];
        store(plane.origin - column * plane.dx - row * plane.dy, whole);
        store(plane.dx, dx);
        store(plane.dy, dy);
        for (std::uint32_t left = bits_of(where); left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            records.of(i + lane)[static_cast<std::size_t>(k)] = {whole[lane], dx[lane], dy[lane], 0,
                                                                 0};
        }
    }

    const PolygonStreams& streams_;
    const Attributes& attributes_;
};

/// The values of records at the pixels of one vector, all in one row. Where they are few, whole
/// vectors of each are worked out and mixed; else each lane fetches its own numbers.
class RecordReader {
public:
    RecordReader(const AttributeRecords& records, int x, int y)
        : records_(records), x_(Ints(x) + iota()), y_(y) {}

    /// All attributes of the lanes, whose `record` is not negative.
    void read(Ints record, Floats* to) const {
        std::int32_t numbers[lane_count];
        store(record, numbers);
        Ints value[most_attributes];
        write_one(numbers[0], first_lanes(lane_count), value);
        auto left = bits_of(record != Ints(numbers[0]));
        for (int mixed = 1; left != 0; ++mixed) {
            if (mixed == most_mixed) return gather_all(record, to);
            const std::int32_t number = numbers[std::countr_zero(left)];
            const Mask where = record == Ints(number);
            write_one(number, where, value);
            left &= ~bits_of(where);
        }
        for (int k = 0; k < records_.attribute_count; ++k)
            to[k] = float_lanes(value[k]);
    }

private:
    static constexpr int most_mixed = lane_count / 3 + 1;

    void write_one(std::int32_t record, Mask where, Ints* value) const {
        const auto n = static_cast<std::size_t>(records_.attribute_count);
        const AttributeRecord* r = &records_.attributes[static_cast<std::size_t>(record) * n];
        for (std::size_t k = 0; k < n; ++k)
            value[k] = select(where, value_of(r[k]), value[k]);
    }

    Ints value_of(const AttributeRecord& r) const {
        const Ints value = Ints(at_row(r)) + x_ * Ints(r.dx);
        if (!records_.has_fractions) return value;
        return value + shift_right<ramp_bits>(Ints(r.fraction) + x_ * Ints(r.fraction_dx));
    }

    /// Modulo 2^32.
    std::int32_t at_row(const AttributeRecord& r) const {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(r.whole) +
                                         static_cast<std::uint32_t>(y_) *
                                             static_cast<std::uint32_t>(r.dy));
    }

    void gather_all(Ints record, Floats* to) const {
        const auto fields = static_cast<std::int32_t>(record_fields);
        const Ints at = record * Ints(records_.attribute_count * fields);
        for (int k = 0; k < records_.attribute_count; ++k)
            to[k] = float_lanes(gathered(at + Ints(k * fields)));
    }

    Ints gathered(Ints at) const {
        const std::int32_t* base = &records_.attributes.data()->whole;
        const Ints value =
            gather(base, at) + x_ * gather(base + 1, at) + Ints(y_) * gather(base + 2, at);
        if (!records_.has_fractions) return value;
        return value + shift_right<ramp_bits>(gather(base + 3, at) + x_ * gather(base + 4, at));
    }

    const AttributeRecords& records_;
    Ints x_;
    std::int32_t y_;
};

/// The attributes of a vector of pixels.
struct AttributeLanes {
    Floats value[most_attributes];
};

}  // namespace scanlight::raster::HWY_NAMESPACE
