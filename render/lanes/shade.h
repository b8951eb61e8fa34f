#pragma once

#include <utility>

#include "raster/lanes/attributes.h"
#include "raster/lanes/numbers.h"
#include "raster/lanes/pack.h"
#include "render/object_pass.h"
#include "render/painted.h"
#include "render/undivided.h"
#include "render/viewing.h"

namespace scanlight::shading {
template <>
struct Format<raster::HWY_NAMESPACE::Floats> : Format<float> {};
}  // namespace scanlight::shading

namespace scanlight::render::HWY_NAMESPACE {

using namespace raster::HWY_NAMESPACE;
using VectorLanes = shading::Vec3<Floats>;
using ColorLanes = shading::Rgb<Floats>;

/// Vectors that lie one after another in memory.
inline VectorLanes gather(const std::vector<glm::vec3>& vectors, Ints index) {
    const float* base = &vectors.data()->x;
    const Ints first = index * Ints(3);
    return {gather(base, first), gather(base, first + Ints(1)), gather(base, first + Ints(2))};
}

/// Calls `light(material)` for each of the materials among the wanted lanes, and joins what comes
/// of it. Most vectors have one.
template <class Light>
ColorLanes by_material(const std::vector<shading::Material<float>>& materials, Ints material,
                       Mask wanted, Light&& light) {
    ColorLanes result(Floats(0));
    for (std::uint32_t left = bits_of(wanted); left != 0;) {
        std::int32_t numbers[lane_count];
        store(material, numbers);
        const std::int32_t number = numbers[std::countr_zero(left)];
        const Mask same = material == Ints(number);
        result = shading::select(same, light(materials[static_cast<std::size_t>(number)]), result);
        left &= ~bits_of(same);
    }
    return result;
}

/// `by_material` for an object, most of which have one material.
template <class Light>
ColorLanes light_by_material(const ObjectPass& pass, Ints face, Mask wanted, Light&& light) {
    const auto& materials = pass.object->materials;
    if (materials.size() == 1) return light(materials.front());
    const auto* numbers = reinterpret_cast<const std::int32_t*>(pass.mesh().face_material.data());
    return by_material(materials, gather(numbers, face), wanted, light);
}

// ---- targets: how a vector of colours becomes pixels

struct FloatPixels {
    raster::Plane<raster::Rgba>& plane;
    static constexpr bool is_packed = false;

    void store_at(int x, int y, Mask where, const ColorLanes& color) const {
        float pixels[4 * lane_count];
        hn::StoreInterleaved4(color.x.v, color.y.v, color.z.v, Floats(1).v, FloatTag(), pixels);
        const auto row = plane.row(y);
        for (std::uint32_t left = bits_of(where); left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            row[static_cast<std::size_t>(x + i)] = {pixels[4 * i], pixels[4 * i + 1],
                                                    pixels[4 * i + 2], pixels[4 * i + 3]};
        }
    }
};

template <raster::Encoding encoding>
struct PackedPixels {
    raster::Plane<raster::PackedPixel>& plane;
    static constexpr bool is_packed = true;

    static Ints packed(const ColorLanes& color) {
        return pack_lanes<encoding>(color.x, color.y, color.z);
    }
    void store_at(int x, int y, Mask where, const ColorLanes& color) const {
        store_packed(x, y, where, packed(color));
    }
    void store_packed(int x, int y, Mask where, Ints pixels) const {
        auto* const at = reinterpret_cast<std::int32_t*>(plane.row(y).data()) + x;
        if (x + lane_count <= plane.width()) {
            store_where(where, pixels, at);
            return;
        }
        std::int32_t values[lane_count];
        store(pixels, values);
        for (std::uint32_t left = bits_of(where); left != 0; left &= left - 1)
            at[std::countr_zero(left)] = values[std::countr_zero(left)];
    }
};

// ---- techniques: what a vector of pixels looks like

/// A vector of pixels in a row, those whose record is not negative.
struct PixelLanes {
    int x, y;
    Ints depth;
    Ints record;  // 0 where nothing is
    Mask shown;
};

/// One intensity a face: see `FlatTechnique`.
class FlatLanes {
public:
    FlatLanes(const ObjectPass& pass, ShadeScratch& scratch) : pass_(pass), scratch_(scratch) {}

    template <class Pixels>
    void set_up() {
        const std::size_t count = scratch_.records.count;
        scratch_.face_colors.resize(std::max(scratch_.face_colors.x.size(), count + lane_count));
        if (scratch_.face_packed.size() < count + lane_count)
            scratch_.face_packed.resize(count + lane_count);
        with_model(*pass_.settings, [&](auto model) {
            for (std::size_t i = 0; i < count; i += lane_count) {
                const ColorLanes color = face_color(model, faces_at(i, count));
                if constexpr (Pixels::is_packed) {
                    store(Pixels::packed(color), scratch_.face_packed.data() + i);
                } else {
                    store(color.x, scratch_.face_colors.x.data() + i);
                    store(color.y, scratch_.face_colors.y.data() + i);
                    store(color.z, scratch_.face_colors.z.data() + i);
                }
            }
        });
    }

    template <class Pixels>
    void shade(const PixelLanes& lanes, const RecordReader& reader, const Pixels& to) const {
        if constexpr (Pixels::is_packed) {
            to.store_packed(lanes.x, lanes.y, lanes.shown, reader.read(scratch_.face_packed));
        } else {
            const auto& colors = scratch_.face_colors;
            to.store_at(lanes.x, lanes.y, lanes.shown,
                        {reader.read(colors.x), reader.read(colors.y), reader.read(colors.z)});
        }
    }

private:
    Ints faces_at(std::size_t i, std::size_t count) const {
        const int n = static_cast<int>(std::min<std::size_t>(lane_count, count - i));
        return select(first_lanes(n), load(scratch_.records.face.data() + i), Ints(0));
    }

    template <class Model>
    ColorLanes face_color(const Model& model, Ints item) const {
        const Ints face = item & Ints(static_cast<std::int32_t>(raster::face_mask));
        const VectorLanes point = mean_corner(face);
        const VectorLanes normal = transformed_normal(pass_.placing.normals_from_object,
                                                      gather(pass_.mesh().face_normals, face));
        const VectorLanes seen = shading::select(item < Ints(0), -normal, normal);
        const shading::Surface<Floats> surface{point, seen,
                                               view_from(pass_.frame->viewpoint, point)};
        return light_by_material(pass_, face, first_lanes(lane_count), [&](const auto& material) {
            return with_paint(pass_.mesh(), [&](auto paint) {
                return illuminate(model, surface,
                                  painted_by<paint>(material, [&] { return mean_color(face); }),
                                  pass_.frame->lighting);
            });
        });
    }

    /// Calls `add(vertex, has)` with the corners of each lane's face in their order.
    template <class Add>
    Floats for_each_corner(Ints face, Add&& add) const {
        const auto* begins = reinterpret_cast<const std::int32_t*>(pass_.mesh().face_begin.data());
        const auto* corners = reinterpret_cast<const std::int32_t*>(pass_.mesh().corners.data());
        const Ints begin = gather(begins, face);
        const Ints count = gather(begins, face + Ints(1)) - begin;
        for (Ints k(0); any(k < count); k += Ints(1)) {
            const Mask has = k < count;
            add(gather(corners, begin + select(has, k, Ints(0))), has);
        }
        return floats_of(count);
    }

    /// The mean of the corners' vectors, added in their order.
    VectorLanes mean(const std::vector<float>& x, const std::vector<float>& y,
                     const std::vector<float>& z, Ints face) const {
        VectorLanes sum(Floats(0));
        const Floats count = for_each_corner(face, [&](Ints vertex, Mask has) {
            const VectorLanes corner(gather(x.data(), vertex), gather(y.data(), vertex),
                                     gather(z.data(), vertex));
            sum = shading::select(has, sum + corner, sum);
        });
        return {sum.x / count, sum.y / count, sum.z / count};
    }
    VectorLanes mean_corner(Ints face) const {
        const auto& points = pass_.vertices.points;
        return mean(points.x, points.y, points.z, face);
    }
    ColorLanes mean_color(Ints face) const {
        const auto& v = pass_.mesh().vertices;
        return mean(v.red, v.green, v.blue, face);
    }

    const ObjectPass& pass_;
    ShadeScratch& scratch_;
};

/// a = (a q) / q, see `undivided`.
inline ColorLanes undivided_lanes(const ColorLanes& a_q, Floats q) {
    const Floats smallest(1.0f / raster::attribute_one);
    return a_q * (Floats(1) / select(q < smallest, smallest, q));
}

/// Interpolated intensities: see `GouraudTechnique`.
class GouraudLanes {
public:
    GouraudLanes(const ObjectPass& pass, ShadeScratch& scratch)
        : pass_(pass), records_(scratch.records) {}

    template <class Pixels>
    void set_up() {}

    template <class Pixels>
    void shade(const PixelLanes& lanes, const RecordReader& reader, const Pixels& to) const {
        const ColorLanes color(reader.value(0), reader.value(1), reader.value(2));
        to.store_at(lanes.x, lanes.y, lanes.shown,
                    undivided_lanes(color, reader.value(3)) * Floats(pass_.unit));
    }

private:
    const ObjectPass& pass_;
    const raster::AttributeRecords& records_;
};

/// Interpolated normals, lit pixel by pixel: see `PhongTechnique`.
template <class Model, Paint paint>
class PhongLanes {
public:
    PhongLanes(const ObjectPass& pass, ShadeScratch& scratch, const Model& model)
        : pass_(pass), records_(scratch.records), model_(model) {}

    template <class Pixels>
    void set_up() {}

    template <class Pixels>
    void shade(const PixelLanes& lanes, const RecordReader& reader, const Pixels& to) const {
        const VectorLanes point = point_at(lanes);
        const shading::Surface<Floats> surface{point, normal_at(lanes, reader),
                                               view_from(pass_.frame->viewpoint, point)};
        const Ints face =
            reader.read(records_.face) & Ints(static_cast<std::int32_t>(raster::face_mask));
        const ColorLanes color =
            light_by_material(pass_, face, lanes.shown, [&](const auto& material) {
                return illuminate(model_, surface,
                                  painted_by<paint>(material, [&] { return vertex_color(reader); }),
                                  pass_.frame->lighting);
            });
        to.store_at(lanes.x, lanes.y, lanes.shown, color);
    }

private:
    /// `Frame::point_at`.
    VectorLanes point_at(const PixelLanes& lanes) const {
        const VectorLanes screen(floats_of(Ints(lanes.x) + iota()) + Floats(0.5f),
                                 Floats(static_cast<float>(lanes.y) + 0.5f),
                                 ndc_from_depth_lanes(lanes.depth));
        return point_behind(pass_.frame->world_from_screen, screen);
    }
    static Floats ndc_from_depth_lanes(Ints depth) {
        return floats_of(depth) * Floats(raster::ndc_a_depth);
    }

    VectorLanes normal_at(const PixelLanes& lanes, const RecordReader& reader) const {
        const VectorLanes n(reader.value(0), reader.value(1), reader.value(2));
        const VectorLanes nowhere(Floats(0));
        const VectorLanes normal = shading::unit_or(n, nowhere);
        const Mask lost = lanes.shown & !(shading::dot(normal, normal) > Floats(0));
        return any(lost) ? shading::unit_or(n, face_normal(reader)) : normal;
    }

    VectorLanes face_normal(const RecordReader& reader) const {
        const Ints item = reader.read(records_.face);
        const Ints face = item & Ints(static_cast<std::int32_t>(raster::face_mask));
        const VectorLanes normal = transformed_normal(pass_.placing.normals_from_object,
                                                      gather(pass_.mesh().face_normals, face));
        return shading::select(item < Ints(0), -normal, normal);
    }

    ColorLanes vertex_color(const RecordReader& reader) const {
        const ColorLanes color(reader.value(3), reader.value(4), reader.value(5));
        return undivided_lanes(color, reader.value(6));
    }

    const ObjectPass& pass_;
    const raster::AttributeRecords& records_;
    Model model_;
};

// ---- the walk over a band

/// The lanes where nothing is take the record of one where something is.
inline Ints with_neighbours(Ints record, Mask shown) {
    std::int32_t records[lane_count];
    store(record, records);
    return select(shown, record, Ints(records[std::countr_zero(bits_of(shown))]));
}

/// Every vector of pixels of the band that shows something.
template <class Technique, class Pixels>
HWY_FLATTEN std::size_t shade_pixels(Technique technique, const raster::AttributeRecords& records,
                                     raster::VisibleBand& band, const Pixels& to) {
    technique.template set_up<Pixels>();
    std::size_t shaded = 0;
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        const raster::Item* const row = band.item_row(y);
        const raster::Depth* const depth = band.depth_row(y);
        for (int x = 0; x < band.width(); x += lane_count) {
            const Ints record = load(row + x);
            const Mask shown = Ints(-1) < record;
            if (!any(shown)) continue;
            const Ints safe = all(shown) ? record : with_neighbours(record, shown);
            technique.shade(PixelLanes{x, y, load(depth + x), safe, shown},
                            RecordReader(records, safe, x, y), to);
            shaded += static_cast<std::size_t>(count(shown));
        }
    }
    return shaded;
}

}  // namespace scanlight::render::HWY_NAMESPACE
