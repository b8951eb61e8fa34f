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

/// The values of records at the pixels of one vector, all in one row.
class RecordReader {
public:
    /// `record` is not negative.
    RecordReader(const AttributeRecords& records, Ints record, int x, int y)
        : records_(records), record_(record), x_(Ints(x) + iota()), y_(y) {
        store(record, numbers_);
        const Mask first = record == Ints(numbers_[0]);
        is_one_ = all(first);
        distinct_[0] = {numbers_[0], first};
        if (!is_one_) find_distinct(bits_of(!first));
    }

    /// All attributes, to `to`.
    void values(Floats* to) const {
        for (int k = 0; k < records_.attribute_count; ++k)
            to[k] = value(k);
    }

    /// Attribute k.
    Floats value(int k) const {
        if (distinct_count_ > most_distinct) return float_lanes(gathered(k));
        Ints value = of_one(distinct_[0].record, k);
        for (int i = 1; i < distinct_count_; ++i)
            value = select(distinct_[i].where, of_one(distinct_[i].record, k), value);
        return float_lanes(value);
    }

    /// One number a record.
    Ints read(const std::vector<std::int32_t>& stream) const {
        return is_one_ ? Ints(stream[static_cast<std::size_t>(numbers_[0])])
                       : gather(stream.data(), record_);
    }
    Floats read(const std::vector<float>& stream) const {
        return is_one_ ? Floats(stream[static_cast<std::size_t>(numbers_[0])])
                       : gather(stream.data(), record_);
    }

private:
    // Up to so many records it is faster to work out whole vectors of each, and to mix them.
    static constexpr int most_distinct = lane_count / 3 + 1;

    struct Distinct {
        std::int32_t record;
        Mask where;
    };

    void find_distinct(std::uint32_t left) {
        for (; left != 0; ++distinct_count_) {
            if (distinct_count_ == most_distinct) {
                ++distinct_count_;
                return;
            }
            const std::int32_t number = numbers_[std::countr_zero(left)];
            const Mask where = record_ == Ints(number);
            distinct_[distinct_count_] = {number, where};
            left &= ~bits_of(where);
        }
    }

    Ints of_one(std::int32_t record, int k) const {
        const auto n = static_cast<std::size_t>(records_.attribute_count);
        const AttributeRecord& r =
            records_.attributes[static_cast<std::size_t>(record) * n + static_cast<std::size_t>(k)];
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

    Ints gathered(int k) const {
        const auto* base = &records_.attributes[static_cast<std::size_t>(k)].whole;
        const Ints at =
            record_ * Ints(records_.attribute_count * static_cast<std::int32_t>(record_fields));
        const Ints value =
            gather(base, at) + x_ * gather(base + 1, at) + Ints(y_) * gather(base + 2, at);
        if (!records_.has_fractions) return value;
        return value + shift_right<ramp_bits>(gather(base + 3, at) + x_ * gather(base + 4, at));
    }

    const AttributeRecords& records_;
    Ints record_;
    Ints x_;
    std::int32_t y_;
    std::int32_t numbers_[lane_count];
    Distinct distinct_[most_distinct];
    int distinct_count_ = 1;
    bool is_one_;  // all lanes have the same record
};

/// The attributes of a vector of pixels.
struct AttributeLanes {
    Floats value[most_attributes];
};

/// `record` is not negative.
SCANLIGHT_FLATTEN inline void read_attributes(const AttributeRecords& records, Ints record, int x,
                                              int y, AttributeLanes& to) {
    RecordReader(records, record, x, y).values(to.value);
}

}  // namespace scanlight::raster::HWY_NAMESPACE
