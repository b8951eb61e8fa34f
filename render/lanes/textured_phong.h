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
        const glm::mat4& world_from_screen = pass_.frame->world_from_screen;
        const VectorLanes screen = screen_at(pixels);
        const VectorLanes point = point_behind(world_from_screen, screen);
        const Floats inverse_w = Floats(1) / point_component(world_from_screen, 3, screen);
        return {{point, normal_at(pass_, pixels), view_from(pass_.frame->viewpoint, point)},
                site_at(pixels, point, own_uv(pixels), inverse_w),
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
    ColorLanes lit(const FaceLanes& faces, const Surface& surface, const Look<Floats>& look,
                   std::size_t number) const {
        return illuminate_textured(model_, surface, look, pass_.object->materials[number],
                                   pass_.textures[number], *pass_.frame,
                                   Unshadowed{faces.shadowed});
    }

    shading::TextureSite<Floats> site_at(const PixelLanes& pixels, const VectorLanes& point,
                                         const glm::vec<2, Floats>& uv, Floats inverse_w) const {
        const Ints face = pixels.face();
        return {point, uv, uv_steps(face, uv, inverse_w), gradients(face),
                steps(face, point, inverse_w)};
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

    std::optional<shading::PixelSteps<glm::vec<2, Floats>>> uv_steps(Ints face,
                                                                     const glm::vec<2, Floats>& uv,
                                                                     Floats inverse_w) const {
        if (!pass_.needs.uv_steps) return {};
        return uv_steps_at(face_uv_steps(pass_, face), uv, inverse_w);
    }

    std::optional<shading::UvGradients<Floats>> gradients(Ints face) const {
        if (!pass_.needs.gradients) return {};
        return face_gradients(pass_, face);
    }

    std::optional<shading::PixelSteps<VectorLanes>> steps(Ints face, const VectorLanes& point,
                                                          Floats inverse_w) const {
        if (!pass_.needs.steps) return {};
        const FaceMatrices& m = pass_.face_matrices;
        const auto steps = face_steps(m.object_from_screen, m.world_from_screen,
                                      gather(pass_.mesh().face_normals, face),
                                      gather(pass_.mesh().face_offset.data(), face));
        return steps_at(steps, point, inverse_w);
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
