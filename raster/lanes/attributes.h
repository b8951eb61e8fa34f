#pragma once

#include "raster/attributes.h"
#include "raster/lane_path.h"
#include "raster/lanes/planes.h"

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

/// The planes of N attributes for as many triangles as there are lanes: at the centre of pixel
/// (x, y) an attribute is whole + x dx + y dy modulo 2^32, exactly what `Planar` comes to there by
/// repeated addition.
template <int N>
struct alignas(64) PreparedAttributes {
    std::int32_t whole[N + 1][lane_count], dx[N + 1][lane_count], dy[N + 1][lane_count];
};

/// See `CornerAttributes`: those of as many polygons as there are lanes.
template <int N>
struct alignas(64) PreparedCorners {
    std::int32_t value[CornerAttributes::most_corners][N + 1][lane_count];

    CornerAttributes operator[](int lane) const {
        return {&value[0][0][lane], lane_count, lane_count * (N + 1)};
    }
};

/// Sets up the attributes of whole triangles, a lane a triangle.
class AttributePreparer {
public:
    explicit AttributePreparer(const Attributes& attributes) : attributes_(attributes) {}

    /// `back`: which are seen from the back.
    template <int N>
    void prepare(const PlaneSetupLanes& setup, const TriangleLanes& v, Mask back, Ints column,
                 Ints row, PreparedAttributes<N>& out) const {
        const Scales scales = scales_of(v);
        for (int k = 0; k < N; ++k) {
            const auto& stream = attributes_.streams[static_cast<std::size_t>(k)];
            const AttributePlaneLanes plane = attribute_plane(
                setup, corner(stream, v.a, back, scales.a), corner(stream, v.b, back, scales.b),
                corner(stream, v.c, back, scales.c));
            store(plane.origin - column * plane.dx - row * plane.dy, out.whole[k]);
            store(plane.dx, out.dx[k]);
            store(plane.dy, out.dy[k]);
        }
    }

    /// Those of the polygons' corners, see `CornerAttributes`; a lane a polygon. One with fewer
    /// corners repeats its last.
    template <int N>
    void prepare(const PolygonStreams& streams, Ints face, Mask back,
                 PreparedCorners<N>& out) const {
        constexpr int corners = CornerAttributes::most_corners;
        const auto* begins = reinterpret_cast<const std::int32_t*>(streams.face_begin.data());
        const auto* vertices = reinterpret_cast<const std::int32_t*>(streams.corners.data());
        const Ints begin = gather(begins, face);
        const Ints last = gather(begins, face + Ints(1)) - Ints(1);
        Ints vertex[corners];
        for (int c = 0; c < corners; ++c)
            vertex[c] = gather(vertices, min(begin + Ints(c), last));
        Floats scale[corners];
        find_scales(vertex, scale);
        for (int k = 0; k < N; ++k) {
            for (int c = 0; c < corners; ++c) {
                store(corner(attributes_.streams[static_cast<std::size_t>(k)], vertex[c], back,
                             scale[c]),
                      out.value[c][k]);
            }
        }
    }

private:
    /// w of the nearest corner by that of each, see `project_correct`.
    template <std::size_t count>
    void find_scales(const Ints (&vertex)[count], Floats (&scale)[count]) const {
        std::ranges::fill(scale, Floats(1));
        if (!attributes_.perspective_correct) return;
        for (std::size_t c = 0; c < count; ++c)
            scale[c] = gather(attributes_.w.data(), vertex[c]);
        Floats least = scale[0];
        for (std::size_t c = 1; c < count; ++c)
            least = smaller(least, scale[c]);
        for (Floats& s : scale)
            s = least / s;
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

    const Attributes& attributes_;
};

/// The attributes of one triangle at a vector of pixels.
template <int N>
class PlaneValues {
public:
    /// The first lane is pixel (x, y), each one on the right a pixel further.
    PlaneValues(const PreparedAttributes<N>& planes, int lane, int x, int y) {
        for (int k = 0; k < N; ++k) {
            value_[k] =
                Ints(attribute_at(planes, k, lane, x, y)) + iota() * Ints(planes.dx[k][lane]);
            step_[k] = Ints(0);
        }
    }
    /// Steps go down, a row at a time.
    void step_down(const PreparedAttributes<N>& planes, int lane) {
        for (int k = 0; k < N; ++k)
            step_[k] = Ints(planes.dy[k][lane]);
    }
    /// Steps go to the right, a vector at a time.
    void step_right(const PreparedAttributes<N>& planes, int lane) {
        for (int k = 0; k < N; ++k)
            step_[k] = Ints(planes.dx[k][lane]) * Ints(lane_count);
    }

    void get(Ints* to) const {
        for (int k = 0; k < N; ++k)
            to[k] = value_[k];
    }
    void step() {
        for (int k = 0; k < N; ++k)
            value_[k] += step_[k];
    }

    /// Modulo 2^32.
    static std::int32_t attribute_at(const PreparedAttributes<N>& planes, int k, int lane, int x,
                                     int y) {
        const auto bits = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
        return static_cast<std::int32_t>(bits(planes.whole[k][lane]) +
                                         bits(x) * bits(planes.dx[k][lane]) +
                                         bits(y) * bits(planes.dy[k][lane]));
    }

private:
    Ints value_[N + 1];
    Ints step_[N + 1];
};

}  // namespace scanlight::raster::HWY_NAMESPACE
