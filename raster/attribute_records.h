#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/polygon_streams.h"
#include "raster/span.h"
#include "raster/streams.h"

namespace scanlight::raster {

inline constexpr int most_attributes = 7;

/// An attribute of all vertices of a mesh, for polygons seen from the front and from the back, each
/// times its scale. Null stands for 1.
struct AttributeStream {
    const float* front = nullptr;
    const float* back = nullptr;
    float front_scale = 1.0f;
    float back_scale = 1.0f;

    float at(std::uint32_t vertex, FaceItem face) const {
        if (front == nullptr) return 1.0f;
        return (face & back_flag) == 0 ? front[vertex] * front_scale : back[vertex] * back_scale;
    }
};

/// What is interpolated over the polygons of one mesh.
struct Attributes {
    std::array<AttributeStream, most_attributes> streams;
    int count = 0;
    std::span<const float> w;          // of each vertex, clip space
    bool perspective_correct = false;  // see `project_correct`
};

/// A number over one row of one polygon, or over all of a triangle: at the centre of pixel (x, y)
///     (whole + x dx + y dy) + (fraction + x fraction_dx) / 2^16, rounded down,
/// modulo 2^32: exactly what `Planar` and `Bilinear` come to there by repeated addition.
struct AttributeRecord {
    std::int32_t whole, dx, dy, fraction, fraction_dx;
};

/// One attribute of many records: structure of arrays.
struct AttributeColumn {
    std::vector<std::int32_t> whole, dx, dy, fraction, fraction_dx;

    void resize(std::size_t n) {
        for (auto* stream : {&whole, &dx, &dy, &fraction, &fraction_dx})
            stream->resize(n);
    }
    void set(std::size_t record, const AttributeRecord& to) {
        whole[record] = to.whole;
        dx[record] = to.dx;
        dy[record] = to.dy;
        fraction[record] = to.fraction;
        fraction_dx[record] = to.fraction_dx;
    }
    std::size_t bytes() const { return bytes_held(whole, dx, dy, fraction, fraction_dx); }
};

/// The attributes of all that a band has come to show: a record for each triangle with a plane, and
/// one for each span of a polygon that is walked.
struct AttributeRecords {
    int attribute_count = 0;
    std::array<AttributeColumn, most_attributes> attributes;  // the first of them
    std::vector<std::int32_t> face;  // FaceItem; with `walk_flag`, it is of one span only
    std::size_t count = 0;
    bool has_fractions = false;  // else they are all 0

    /// No records, of so many attributes each.
    void clear(int attributes_each);

    /// Room for n records, and a vector more.
    void reserve(std::size_t n) {
        if (face.size() < n + most_lanes) grow(2 * n + most_lanes);
    }

    std::size_t bytes() const;

private:
    void grow(std::size_t n);
};

/// The ramp of a span as a record that counts x from the picture's edge. Modulo 2^64.
AttributeRecord record_of(const Ramp& ramp, int x_begin);

}  // namespace scanlight::raster
