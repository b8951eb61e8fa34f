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
                      AttributeColumn& to, std::size_t i) {
        store_where(where, plane.origin - column * plane.dx - row * plane.dy, to.whole.data() + i);
        store_where(where, plane.dx, to.dx.data() + i);
        store_where(where, plane.dy, to.dy.data() + i);
        store_where(where, Ints(0), to.fraction.data() + i);
        store_where(where, Ints(0), to.fraction_dx.data() + i);
    }

    const PolygonStreams& streams_;
    const Attributes& attributes_;
};

/// Calls `use(x, item)` with the first pixel of each run of pixels of one record, and with each
/// first pixel of a vector: from left to right, so that whoever writes a vector's worth there has
/// written all of the run, and overwrites what was written too far.
template <class Use>
void for_each_run(const Item* items, Columns columns, Use&& use) {
    for (int x = columns.begin; x < columns.end; x += lane_count) {
        std::uint32_t begins = bits_of(load(items + x) != load(items + x - 1)) | 1;
        for (; begins != 0; begins &= begins - 1) {
            const int at = x + std::countr_zero(begins);
            if (items[at] >= 0) use(at, static_cast<std::size_t>(items[at]));
        }
    }
}

/// The attributes of a vector of pixels.
struct AttributeLanes {
    Floats value[most_attributes];
};

/// The values of records at the pixels of one vector, all in one row. Where they are few, their
/// numbers are mixed lane by lane; else each lane fetches its own.
class RecordReader {
public:
    RecordReader(const AttributeRecords& records, int x, int y)
        : records_(records), x_(Ints(x) + iota()), y_(y) {}

    /// All attributes of the lanes, whose `record` is not negative.
    AttributeLanes read(Ints record) const {
        std::int32_t numbers[lane_count];
        store(record, numbers);
        Numbers mixed[most_attributes];
        mix(numbers[0], first_lanes(lane_count), mixed);
        auto left = bits_of(record != Ints(numbers[0]));
        for (int records = 1; left != 0; ++records) {
            if (records == most_mixed) return values_of([&](int k) { return gathered(k, record); });
            const std::int32_t number = numbers[std::countr_zero(left)];
            const Mask where = record == Ints(number);
            mix(number, where, mixed);
            left &= ~bits_of(where);
        }
        return values_of([&](int k) { return mixed[k]; });
    }

private:
    static constexpr int most_mixed = lane_count / 3 + 1;

    /// `AttributeRecord`, lane by lane.
    struct Numbers {
        Ints whole, dx, dy, fraction, fraction_dx;
    };

    const AttributeColumn& column(int k) const {
        return records_.attributes[static_cast<std::size_t>(k)];
    }

    void mix(std::int32_t record, Mask where, Numbers* to) const {
        const auto r = static_cast<std::size_t>(record);
        const auto mixed = [&](const std::vector<std::int32_t>& stream, Ints others) {
            return select(where, Ints(stream[r]), others);
        };
        for (int k = 0; k < records_.attribute_count; ++k) {
            const AttributeColumn& a = column(k);
            to[k].whole = mixed(a.whole, to[k].whole);
            to[k].dx = mixed(a.dx, to[k].dx);
            to[k].dy = mixed(a.dy, to[k].dy);
            if (!records_.has_fractions) continue;
            to[k].fraction = mixed(a.fraction, to[k].fraction);
            to[k].fraction_dx = mixed(a.fraction_dx, to[k].fraction_dx);
        }
    }

    Numbers gathered(int k, Ints record) const {
        const AttributeColumn& a = column(k);
        Numbers n;
        n.whole = gather(a.whole.data(), record);
        n.dx = gather(a.dx.data(), record);
        n.dy = gather(a.dy.data(), record);
        if (!records_.has_fractions) return n;
        n.fraction = gather(a.fraction.data(), record);
        n.fraction_dx = gather(a.fraction_dx.data(), record);
        return n;
    }

    template <class NumbersOf>
    AttributeLanes values_of(NumbersOf&& numbers_of) const {
        AttributeLanes result;
        for (int k = 0; k < records_.attribute_count; ++k)
            result.value[k] = float_lanes(value_of(numbers_of(k)));
        return result;
    }

    Ints value_of(const Numbers& n) const {
        const Ints whole = n.whole + Ints(y_) * n.dy + x_ * n.dx;
        if (!records_.has_fractions) return whole;
        return whole + shift_right<ramp_bits>(n.fraction + x_ * n.fraction_dx);
    }

    const AttributeRecords& records_;
    Ints x_;
    std::int32_t y_;
};

}  // namespace scanlight::raster::HWY_NAMESPACE
