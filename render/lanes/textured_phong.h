#pragma once

#include "render/lanes/pixel_lanes.h"
#include "render/textured.h"

namespace scanlight::render::HWY_NAMESPACE {

/// What is on record of the pixels' faces for textures, object space. Neighbours show few faces: to
/// fetch a face's numbers once, for all its pixels, takes less time than once for each of them.
struct FaceLanes {
    VectorLanes normal{Floats(0)}, grad_u{Floats(0)}, grad_v{Floats(0)};
    Floats offset{0};

    FaceLanes(const mesh::Mesh& mesh, const PixelLanes& pixels, bool with_gradients) {
        const auto fetch_one = [&](std::int32_t face, Mask where) {
            fetch(mesh, static_cast<std::size_t>(face), where, with_gradients);
        };
        const Mask all = first_lanes(lane_count);
        if (!for_each_number(pixels.face(), all, few, fetch_one))
            fetch_each(mesh, pixels.face(), with_gradients);
    }

private:
    static constexpr int few = 5;

    void fetch_each(const mesh::Mesh& mesh, Ints face, bool with_gradients) {
        normal = gather(mesh.face_normals, face);
        offset = gather(mesh.face_offset.data(), face);
        if (!with_gradients) return;
        grad_u = gather(mesh.face_grad_u, face);
        grad_v = gather(mesh.face_grad_v, face);
    }
    void fetch(const mesh::Mesh& mesh, std::size_t face, Mask where, bool with_gradients) {
        put(mesh.face_normals[face], where, normal);
        offset = select(where, Floats(mesh.face_offset[face]), offset);
        if (!with_gradients) return;
        put(mesh.face_grad_u[face], where, grad_u);
        put(mesh.face_grad_v[face], where, grad_v);
    }
    static void put(const glm::vec3& v, Mask where, VectorLanes& to) {
        to = shading::select(where, VectorLanes(Floats(v.x), Floats(v.y), Floats(v.z)), to);
    }
};

/// See `TexturedPhongTechnique`.
template <class Model>
class TexturedPhongLanes {
public:
    const int attributes;

    TexturedPhongLanes(const ObjectPass& pass, const Model& model)
        : attributes(pass.textured.count()), pass_(pass), model_(model) {}

    ColorLanes shade(const PixelLanes& pixels) const {
        const TexturedSurface<Floats> surface = surface_at(pixels);
        return light_by_number(pass_, pixels.face(), pixels.shown, [&](std::size_t number) {
            return illuminate_textured(model_, surface, pass_.object->materials[number],
                                       pass_.textures[number], *pass_.frame,
                                       Unshadowed{pixels.shadowed});
        });
    }
    Floats opacity(const PixelLanes& pixels) const {
        const TexturedSurface<Floats> surface = surface_at(pixels);
        const auto of_material = [&](std::size_t number) {
            return ColorLanes(
                opacity_on(pass_.object->materials[number], pass_.textures[number], surface.site));
        };
        return light_by_number(pass_, pixels.face(), pixels.shown, of_material).x;
    }

private:
    TexturedSurface<Floats> surface_at(const PixelLanes& pixels) const {
        const glm::mat4& world_from_screen = pass_.frame->world_from_screen;
        const VectorLanes screen = screen_at(pixels);
        const VectorLanes point = point_behind(world_from_screen, screen);
        const Floats inverse_w = Floats(1) / point_component(world_from_screen, 3, screen);
        const FaceLanes face(pass_.mesh(), pixels, pass_.textured.has_uvs);
        const auto steps = face_steps(pass_.face_matrices, face.normal, face.offset);
        return {{point, normal_at(pass_, pixels), view_from(pass_.frame->viewpoint, point)},
                {point, own_place(pixels, face), pixel_step(steps.right, point, inverse_w),
                 pixel_step(steps.down, point, inverse_w)},
                color(pixels),
                select(pixels.back(), Floats(-1), Floats(1))};
    }

    ColorLanes color(const PixelLanes& pixels) const {
        if (!pass_.textured.has_colors) return ColorLanes(Floats(1));
        return undivided(pixels, pass_.textured.colors(), 3);
    }

    shading::TexturePlace<Floats> own_place(const PixelLanes& pixels, const FaceLanes& face) const {
        const VectorLanes nothing(Floats(0));
        if (!pass_.textured.has_uvs) return {Floats(0), Floats(0), nothing, nothing};
        const VectorLanes uv = undivided(pixels, pass_.textured.uvs(), 2);
        const glm::mat3& m = pass_.face_matrices.gradients_from_object;
        return {uv.x * Floats(pass_.uv_unit), uv.y * Floats(pass_.uv_unit),
                transformed_gradient(m, face.grad_u), transformed_gradient(m, face.grad_v)};
    }

    /// So many attributes from the `first` on, divided by q.
    ColorLanes undivided(const PixelLanes& pixels, int first, int count) const {
        const Ints* a = pixels.attributes;
        const Ints third = count == 3 ? a[first + 2] : Ints(0);
        const Ints a_q[4] = {a[first], a[first + 1], third, a[pass_.textured.q()]};
        return undivided_lanes(a_q, 1.0f);
    }

    const ObjectPass& pass_;
    Model model_;
};

}  // namespace scanlight::render::HWY_NAMESPACE
