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

// ---- techniques: what a vector of pixels looks like

/// A vector of pixels in a row.
struct PixelLanes {
    int x, y;
    Ints depth;
    Mask shown;   // somewhere
    Ints record;  // where nothing is shown, that of a pixel where something is
    AttributeLanes attributes;

    VectorLanes vector(int first) const {
        return {attributes.value[first], attributes.value[first + 1], attributes.value[first + 2]};
    }
};

/// One intensity a face: see `FlatTechnique`.
class FlatLanes {
public:
    FlatLanes(const ObjectPass& pass, ShadeScratch& scratch) : pass_(pass), scratch_(scratch) {
        with_model(*pass_.settings, [&](auto model) { light_faces(model); });
    }

    /// The colours of all pixels of a row that show something.
    SCANLIGHT_FLATTEN void shade_row(raster::VisibleBand& band, int y) const {
        const VectorStreams& colors = scratch_.face_colors;
        VectorStreams& row = scratch_.row;
        for_each_run(band.item_row(y), band.touched(), [&](int x, std::size_t record) {
            store(Floats(colors.x[record]), row.x.data() + x);
            store(Floats(colors.y[record]), row.y.data() + x);
            store(Floats(colors.z[record]), row.z.data() + x);
        });
    }

private:
    template <class Model>
    void light_faces(const Model& model) {
        const std::size_t count = scratch_.records.count;
        auto& colors = scratch_.face_colors;
        if (colors.x.size() < count + lane_count) colors.resize(2 * count + lane_count);
        for (std::size_t i = 0; i < count; i += lane_count)
            light_lanes(model, i, count);
    }

    template <class Model>
    SCANLIGHT_FLATTEN void light_lanes(const Model& model, std::size_t i, std::size_t count) {
        const ColorLanes color = face_color(model, faces_at(i, count));
        store(color.x, scratch_.face_colors.x.data() + i);
        store(color.y, scratch_.face_colors.y.data() + i);
        store(color.z, scratch_.face_colors.z.data() + i);
    }

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
    explicit GouraudLanes(const ObjectPass& pass) : unit_(pass.unit) {}

    ColorLanes shade(const PixelLanes& pixels) const {
        return undivided_lanes(pixels.vector(0), pixels.attributes.value[3]) * unit_;
    }

private:
    Floats unit_;
};

/// Interpolated normals, lit pixel by pixel: see `PhongTechnique`.
template <class Model, Paint paint>
class PhongLanes {
public:
    PhongLanes(const ObjectPass& pass, const ShadeScratch& scratch, const Model& model)
        : pass_(pass), records_(scratch.records), model_(model) {}

    ColorLanes shade(const PixelLanes& pixels) const {
        const VectorLanes point = point_at(pixels);
        const shading::Surface<Floats> surface{point, normal_at(pixels),
                                               view_from(pass_.frame->viewpoint, point)};
        return light_by_material(pass_, pixels, [&](const auto& material) {
            return illuminate(model_, surface,
                              painted_by<paint>(material, [&] { return vertex_color(pixels); }),
                              pass_.frame->lighting);
        });
    }

private:
    template <class Light>
    ColorLanes light_by_material(const ObjectPass& pass, const PixelLanes& pixels,
                                 Light&& light) const {
        if (pass.object->materials.size() == 1) return light(pass.object->materials.front());
        return render::HWY_NAMESPACE::light_by_material(pass, face_of(item_of(pixels)),
                                                        pixels.shown, light);
    }
    Ints item_of(const PixelLanes& pixels) const {
        return gather(records_.face.data(), pixels.record);
    }
    static Ints face_of(Ints item) {
        return item & Ints(static_cast<std::int32_t>(raster::face_mask));
    }

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

    VectorLanes normal_at(const PixelLanes& pixels) const {
        const VectorLanes n = pixels.vector(0);
        const VectorLanes normal = shading::unit_or(n, VectorLanes(Floats(0)));
        const Mask lost = pixels.shown & !(shading::dot(normal, normal) > Floats(0));
        return any(lost) ? shading::unit_or(n, face_normal(pixels)) : normal;
    }

    VectorLanes face_normal(const PixelLanes& pixels) const {
        const Ints item = item_of(pixels);
        const VectorLanes normal = transformed_normal(
            pass_.placing.normals_from_object, gather(pass_.mesh().face_normals, face_of(item)));
        return shading::select(item < Ints(0), -normal, normal);
    }

    ColorLanes vertex_color(const PixelLanes& pixels) const {
        return undivided_lanes(pixels.vector(3), pixels.attributes.value[6]);
    }

    const ObjectPass& pass_;
    const raster::AttributeRecords& records_;
    Model model_;
};

// ---- the walk over a band

/// A technique that lights pixel by pixel what its attributes say.
template <class PixelTechnique>
class PixelByPixel {
public:
    PixelByPixel(const PixelTechnique& technique, ShadeScratch& scratch)
        : technique_(technique), scratch_(scratch) {}

    /// The colours of all pixels of a row that show something.
    SCANLIGHT_FLATTEN void shade_row(raster::VisibleBand& band, int y) const {
        const raster::Columns columns = band.touched();
        PixelLanes pixels;
        for (int x = columns.begin; x < columns.end; x += lane_count) {
            if (read(band, x, y, pixels)) write(technique_.shade(pixels), x);
        }
    }

private:
    /// False where nothing is shown.
    bool read(raster::VisibleBand& band, int x, int y, PixelLanes& pixels) const {
        const Ints record = load(band.item_row(y) + x);
        pixels.shown = Ints(-1) < record;
        if (!any(pixels.shown)) return false;
        pixels.x = x;
        pixels.y = y;
        pixels.depth = load(band.depth_row(y) + x);
        pixels.record = all(pixels.shown) ? record : with_neighbours(record, pixels.shown);
        pixels.attributes = RecordReader(scratch_.records, x, y).read(pixels.record);
        return true;
    }

    static Ints with_neighbours(Ints record, Mask shown) {
        std::int32_t records[lane_count];
        store(record, records);
        return select(shown, record, Ints(records[std::countr_zero(bits_of(shown))]));
    }

    void write(const ColorLanes& color, int x) const {
        store(color.x, scratch_.row.x.data() + x);
        store(color.y, scratch_.row.y.data() + x);
        store(color.z, scratch_.row.z.data() + x);
    }

    const PixelTechnique& technique_;
    ShadeScratch& scratch_;
};

}  // namespace scanlight::render::HWY_NAMESPACE
