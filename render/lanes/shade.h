#pragma once

#include <utility>

#include "render/lanes/pixel_lanes.h"
#include "render/lanes/textured_phong.h"
#include "render/painted.h"
#include "render/undivided.h"
#include "shading/few.h"

namespace scanlight::render::HWY_NAMESPACE {

// Techniques: what a vector of pixels looks like. Each says first what surface the pixels show, all
// that its light depends on, and then what light it sends.

/// One intensity a face: see `FlatTechnique`.
class FlatLanes {
public:
    struct Surface {};

    explicit FlatLanes(const ObjectPass& pass) : pass_(pass) {}

    Surface surface(const PixelLanes&) const { return {}; }
    ColorLanes light(const FaceLanes& faces, Surface) const {
        return color_of(faces.item, faces.shadowed);
    }
    Floats opacity(const PixelLanes& pixels) const { return material_opacity(pass_, pixels); }

    /// A lane is a polygon, or a pixel of one.
    ColorLanes color_of(Ints item, Ints shadowed = Ints(0)) const {
        return with_model(pass_.settings, [&](auto model) { return lit(model, item, shadowed); });
    }

private:
    template <class Model>
    SCANLIGHT_FLATTEN ColorLanes lit(const Model& model, Ints item, Ints shadowed) const {
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
                                  pass_.frame->lighting, Unshadowed{shadowed});
            });
        });
    }

    /// The mean of the corners' vectors, added in their order.
    VectorLanes mean(const std::vector<float>& x, const std::vector<float>& y,
                     const std::vector<float>& z, Ints face) const {
        VectorLanes sum(Floats(0));
        const Floats count = for_each_corner(pass_.mesh(), face, [&](Ints vertex, Mask has) {
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
};

/// Interpolated intensities: see `GouraudTechnique`.
class GouraudLanes {
public:
    static constexpr int attributes = 4;
    using Surface = ColorLanes;

    explicit GouraudLanes(const ObjectPass& pass) : pass_(pass), unit_(pass.unit) {}

    /// Of one step of an attribute: a power of two.
    float unit() const { return unit_ / raster::attribute_one; }

    Surface surface(const PixelLanes& pixels) const {
        const Ints a_q[] = {pixels.attribute(0), pixels.attribute(1), pixels.attribute(2),
                            pixels.attribute(3)};
        return color_of(a_q);
    }
    ColorLanes light(const FaceLanes&, const Surface& color) const { return color; }
    Floats opacity(const PixelLanes& pixels) const { return material_opacity(pass_, pixels); }
    ColorLanes color_of(const Ints* attributes) const { return undivided_lanes(attributes, unit_); }

private:
    const ObjectPass& pass_;
    float unit_;
};

/// Interpolated normals, lit pixel by pixel: see `PhongTechnique`.
template <class Model, Paint paint>
class PhongLanes {
public:
    static constexpr bool lights_few = shading::WorksOnFew<Model> && paint == Paint::material;

    struct Surface {
        shading::Surface<Floats> seen;
        ColorLanes color;  // the vertices'
    };

    PhongLanes(const ObjectPass& pass, const Model& model) : pass_(pass), model_(model) {}

    Surface surface(const PixelLanes& pixels) const {
        return {{point_at(pass_, pixels), normal_at(pass_, pixels), view_at(pixels)},
                vertex_color(pixels)};
    }

    ColorLanes light(const FaceLanes& faces, const Surface& surface) const {
        return light_by_material(pass_, faces.face(), faces.shown, [&](const auto& material) {
            return illuminate(model_, surface.seen,
                              painted_by<paint>(material, [&] { return surface.color; }),
                              pass_.frame->lighting, Unshadowed{faces.shadowed});
        });
    }

    /// Calls `write(i, color)` for each of a few vectors of pixels.
    template <class Seen, class Write>
    void light_few(const shading::Few<Seen>& seen, Write&& write) const requires(lights_few) {
        const auto& material = pass_.object->materials.front();
        const auto places = shading::places_of<Floats>(
            seen.count(), [&](int i) -> const auto& { return seen[i].surface.seen; },
            [&](int) -> const auto& { return material; });
        const auto arriving = [&](int i, std::size_t light, const ColorLanes& term) {
            return Unshadowed{seen[i].faces.shadowed}(light, term);
        };
        illuminate_few(model_, places, pass_.frame->lighting, arriving, write);
    }

    Floats opacity(const PixelLanes& pixels) const { return material_opacity(pass_, pixels); }

private:
    static ColorLanes vertex_color(const PixelLanes& pixels) {
        if constexpr (paint != Paint::vertices) return ColorLanes(Floats(0));
        const Ints a_q[] = {pixels.attribute(3), pixels.attribute(4), pixels.attribute(5),
                            pixels.attribute(6)};
        return undivided_lanes(a_q, 1.0f);
    }

    const ObjectPass& pass_;
    Model model_;
};

/// Calls `use` with the technique that lights the object's pixels.
template <class Use>
decltype(auto) with_technique(const ObjectPass& pass, Use&& use) {
    if (pass.settings.shading == Shading::flat) return use(FlatLanes(pass));
    if (pass.settings.shading == Shading::gouraud) return use(GouraudLanes(pass));
    if (!pass.textures.empty()) {
        return with_model(pass.settings, [&](auto model) {
            return use(TexturedPhongLanes<decltype(model)>(pass, model));
        });
    }
    return with_model(pass.settings, [&](auto model) {
        return with_paint(pass.mesh(), [&](auto paint) {
            return use(PhongLanes<decltype(model), paint>(pass, model));
        });
    });
}

}  // namespace scanlight::render::HWY_NAMESPACE
