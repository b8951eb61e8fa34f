#pragma once

#include <algorithm>
#include <span>
#include <variant>

#include "raster/lanes/numbers.h"
#include "raster/lanes/pack.h"
#include "render/object_pass.h"

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;

/// Whole vectors would write beyond the row's end, where another thread's may begin.
inline void store_some(Ints pixels, int room, std::int32_t* to) {
    if (room >= lane_count) return store(pixels, to);
    std::int32_t values[lane_count];
    store(pixels, values);
    std::copy_n(values, room, to);
}

/// The pixels that are there already.
inline Ints kept(const std::int32_t* from, int room) {
    if (room >= lane_count) return load(from);
    std::int32_t values[lane_count] = {};
    std::copy_n(from, room, values);
    return load(values);
}

/// `FaceRange::holds`.
inline Mask lanes_held(FaceRange faces, Ints item) {
    const Ints face =
        (item & Ints(static_cast<std::int32_t>(raster::face_mask))) - Ints(faces.first);
    return (Ints(-1) < face) & (face < Ints(faces.count));
}

/// Columns in which nothing is seen.
inline void store_background(raster::Columns seen, const PackedTarget& target, int y) {
    const auto to = target.row(y);
    std::fill_n(to.begin(), seen.begin, target.background);
    std::fill(to.begin() + seen.end, to.end(), target.background);
}

/// Where a row's colours go as they are found, a vector of pixels after the other.
class RowWriter {
public:
    virtual void write(int x, Mask shown, Floats red, Floats green, Floats blue) noexcept = 0;
    /// Nothing of what is lit shows in the vector from x on.
    virtual void leave_out(int x) noexcept = 0;

protected:
    ~RowWriter() = default;
};

/// To bytes.
template <raster::Encoding encoding>
class PackedRow final : public RowWriter {
public:
    /// Nothing is seen but in some columns.
    PackedRow(const PackedTarget& target, Background background, raster::Columns seen, int y)
        : out_(reinterpret_cast<std::int32_t*>(target.row(y).data())),
          end_(seen.end),
          background_(background),
          nothing_(static_cast<std::int32_t>(target.background)) {
        if (background == Background::drawn) store_background(seen, target, y);
    }

    void write(int x, Mask shown, Floats red, Floats green, Floats blue) noexcept override {
        const int room = end_ - x;
        const Ints packed = pack_lanes<encoding>(red, green, blue);
        const Ints other = background_ == Background::drawn ? Ints(nothing_) : kept(out_ + x, room);
        store_some(select(shown, packed, other), room, out_ + x);
    }
    void leave_out(int x) noexcept override {
        if (background_ == Background::drawn) store_some(Ints(nothing_), end_ - x, out_ + x);
    }

private:
    std::int32_t* out_;
    int end_;
    Background background_;
    std::int32_t nothing_;
};

/// To floats.
class FloatRow final : public RowWriter {
public:
    FloatRow(const FloatTarget& target, Background background, raster::Columns seen, int y)
        : out_(target.row(y)), end_(seen.end) {
        if (background == Background::drawn) std::ranges::fill(out_, target.background);
    }

    void write(int x, Mask shown, Floats red, Floats green, Floats blue) noexcept override {
        const Floats channels[] = {red, green, blue};
        float color[3][lane_count];
        for (int c = 0; c < 3; ++c)
            store(channels[c], color[c]);
        const std::uint32_t bits = bits_of(shown);
        for (int i = 0; i < std::min(lane_count, end_ - x); ++i) {
            if ((bits >> i & 1) == 0) continue;
            out_[static_cast<std::size_t>(x + i)] = {color[0][i], color[1][i], color[2][i], 1.0f};
        }
    }
    void leave_out(int) noexcept override {}

private:
    std::span<raster::Rgba> out_;
    int end_;
};

/// To a row that has room for a vector more.
class StreamRow final : public RowWriter {
public:
    explicit StreamRow(VectorStreams& row) : row_(row) {}

    void write(int x, Mask, Floats red, Floats green, Floats blue) noexcept override {
        store(red, row_.x.data() + x);
        store(green, row_.y.data() + x);
        store(blue, row_.z.data() + x);
    }
    void leave_out(int) noexcept override {}

private:
    VectorStreams& row_;
};

/// Pixels that are kept ready.
SCANLIGHT_FLATTEN inline void store_pixels(raster::VisibleBand& band, int y,
                                           const PackedTarget& target) {
    const raster::Columns columns = band.touched();
    if (columns.begin >= columns.end) return store_background({0, 0}, target, y);
    store_background(columns, target, y);
    auto* out = reinterpret_cast<std::int32_t*>(target.row(y).data());
    const Ints nothing(static_cast<std::int32_t>(target.background));
    for (int x = columns.begin; x < columns.end; x += lane_count) {
        const raster::PixelPlace at = band.row(y) + x;
        const Mask shown = load(at.depth) < Ints(raster::depth_clear);
        store_some(select(shown, load(at.kept(0)), nothing), columns.end - x, out + x);
    }
}

/// Calls `use` with the writer of a row of the target.
template <class Use>
void with_row(const Target& target, Background background, raster::Columns seen, int y, Use&& use) {
    using raster::Encoding;
    if (const auto* floats = std::get_if<FloatTarget>(&target))
        return use(FloatRow(*floats, background, seen, y));
    const auto& packed = *std::get_if<PackedTarget>(&target);  // std::get could throw
    if (packed.encoding == Encoding::srgb)
        return use(PackedRow<Encoding::srgb>(packed, background, seen, y));
    use(PackedRow<Encoding::linear>(packed, background, seen, y));
}

}  // namespace scanlight::render::HWY_NAMESPACE
