#pragma once

#include <vector>

#include "render/lanes/face_uvs.h"
#include "render/lanes/pixel_lanes.h"
#include "render/textured.h"
#include "shading/few.h"

namespace scanlight::render::HWY_NAMESPACE {

/// See `TexturedPhongTechnique`.
template <class Model>
class TexturedPhongLanes {
public:
    using Surface = TexturedSurface<Floats>;

    TexturedPhongLanes(const ObjectPass& pass, const Model& model) : pass_(pass), model_(model) {}

    /// Each part is made in its place: to copy such long ones would take its time.
    Surface surface(const PixelLanes& pixels) const {
        const VectorLanes point = point_at(pass_, pixels);
        return {{point, normal_at(pass_, pixels), view_at(pixels)},
                site_at(pixels, point),
                color(pixels),
                select(pixels.back(), Floats(-1), Floats(1))};
    }

    ColorLanes light(const FaceLanes& faces, const Surface& surface) const {
        return light_by_number(pass_, faces.face(), faces.shown, [&](std::size_t number) {
            return lit(faces, surface, look_of(pass_.textures[number], surface), number);
        });
    }

    /// Calls `write(i, color)` for each of a few vectors of pixels: their textures are looked up
    /// together.
    template <class Seen, class Write>
    void light_few(const shading::Few<Seen>& seen, Write&& write) const {
        const auto surfaces =
            shading::few_of(seen.count(), [&](int i) { return &seen[i].surface; });
        const auto normals = normals_on(pass_.textures.front(), surfaces);
        const auto paints = paints_on(pass_.textures.front(), surfaces);
        if constexpr (shading::WorksOnFew<Model>) {
            if (are_all_in_look(pass_.textures.front(), *pass_.frame))
                return light_painted(seen, normals, paints, write);
        }
        for (int i = 0; i < seen.count(); ++i)
            write(i, lit(seen[i].faces, seen[i].surface, {normals[i], paints[i]}, 0));
    }

    Floats opacity(const PixelLanes& pixels) const {
        const Surface seen = surface(pixels);
        const auto of_material = [&](std::size_t number) {
            return ColorLanes(
                opacity_on(pass_.object->materials[number], pass_.textures[number], seen.site));
        };
        return light_by_number(pass_, pixels.face(), pixels.shown, of_material).x;
    }

private:
    /// Where their look is all that textures say.
    template <class Seen, class Write>
    void light_painted(const shading::Few<Seen>& seen, const shading::Few<VectorLanes>& normals,
                       const shading::Few<ColorLanes>& paints, Write&& write) const {
        const auto& material = pass_.object->materials.front();
        const auto places = shading::places_of<Floats>(
            seen.count(),
            [&](int i) {
                const auto& [point, normal, view] = seen[i].surface.surface;
                return shading::Surface<Floats>{point, normals[i], view};
            },
            [&](int i) { return painted(material, paints[i]); });
        const auto arriving = [&](int i, std::size_t light, const ColorLanes& term) {
            return Unshadowed{seen[i].faces.shadowed}(light, term);
        };
        illuminate_few(model_, places, pass_.frame->lighting, arriving, write);
    }

    ColorLanes lit(const FaceLanes& faces, const Surface& surface, const Look<Floats>& look,
                   std::size_t number) const {
        return illuminate_textured(model_, surface, look, pass_.object->materials[number],
                                   pass_.textures[number], *pass_.frame,
                                   Unshadowed{faces.shadowed});
    }

    shading::TextureSite<Floats> site_at(const PixelLanes& pixels, const VectorLanes& point) const {
        const Ints face = pixels.face();
        const glm::vec<2, Floats> uv = own_uv(pixels);
        return {point, uv, uv_steps(pixels, face, uv), gradients(face), steps(pixels, face, point)};
    }

    Floats inverse_w_at(const PixelLanes& pixels) const {
        return Floats(1) / point_component(pass_.frame->world_from_screen, 3, screen_at(pixels));
    }

    std::optional<ColorLanes> color(const PixelLanes& pixels) const {
        if (!pass_.textured.has_colors) return {};
        return undivided(pixels, pass_.textured.colors(), 3);
    }

    glm::vec<2, Floats> own_uv(const PixelLanes& pixels) const {
        if (!pass_.textured.has_uvs) return glm::vec<2, Floats>(Floats(0));
        const Floats unit(pass_.uv_unit);
        const VectorLanes uv = undivided(pixels, pass_.textured.uvs(), 2);
        return {uv.x * unit, uv.y * unit};
    }

    std::optional<shading::PixelSteps<glm::vec<2, Floats>>> uv_steps(
        const PixelLanes& pixels, Ints face, const glm::vec<2, Floats>& uv) const {
        if (!pass_.needs.uv_steps || are_magnified(pass_, face)) return {};
        return uv_steps_at(face_uv_steps(pass_, face), uv, inverse_w_at(pixels));
    }

    std::optional<shading::UvGradients<Floats>> gradients(Ints face) const {
        if (!pass_.needs.gradients) return {};
        return face_gradients(pass_, face);
    }

    std::optional<shading::PixelSteps<VectorLanes>> steps(const PixelLanes& pixels, Ints face,
                                                          const VectorLanes& point) const {
        if (!pass_.needs.steps) return {};
        const FaceMatrices& m = pass_.face_matrices;
        const auto steps = face_steps(m.object_from_screen, m.world_from_screen,
                                      gather(pass_.mesh().face_normals, face),
                                      gather(pass_.mesh().face_offset.data(), face));
        return steps_at(steps, point, inverse_w_at(pixels));
    }

    /// So many attributes from the `first` on, divided by q.
    ColorLanes undivided(const PixelLanes& pixels, int first, int count) const {
        const Ints third = count == 3 ? pixels.attribute(first + 2) : Ints(0);
        const Ints a_q[] = {pixels.attribute(first), pixels.attribute(first + 1), third,
                            pixels.attribute(pass_.textured.q())};
        return undivided_lanes(a_q, 1.0f);
    }

    const ObjectPass& pass_;
    Model model_;
};

}  // namespace scanlight::render::HWY_NAMESPACE
