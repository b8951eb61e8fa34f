#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "raster/fragments.h"
#include "render/placed_mesh.h"
#include "render/textured.h"
#include "render/undivided.h"

namespace scanlight::render {

/// Phong shading of a textured object with `count` attributes, see `TexturedAttributes`.
template <int count>
class TexturedPhongTechnique {
public:
    static constexpr int attribute_count = count;
    static constexpr TexturedAttributes has{count == 7 || count == 9, count == 6 || count == 9};
    using Pixel = raster::Rgba;

    struct Polygon {
        const shading::Material<float>& material;
        const PlacedTextures& textures;
        glm::vec3 normal;  // of the side seen
        FaceSteps<float> steps;
        FaceUvs<float> uvs;
        float outward;
    };

    TexturedPhongTechnique(const PlacedMesh& placed, const Frame& frame, const Settings& settings)
        : placed_(placed),
          frame_(frame),
          settings_(settings),
          textures_(placed_textures(*placed.object)),
          uv_unit_(has.has_uvs ? uv_unit_of(placed.mesh->vertices) : 1.0f),
          matrices_(face_matrices(*placed.object, frame)) {}

    std::array<float, attribute_count> corner(std::size_t, std::uint32_t vertex, Side side) const {
        const auto& vertices = placed_.mesh->vertices;
        std::array<float, attribute_count> a;
        put(a, 0, placed_.normal_seen(vertex, side));
        if constexpr (has.has_colors) put(a, has.colors(), vertices.color(vertex));
        if constexpr (has.has_uvs) {
            a[at(has.uvs())] = vertices.u[vertex] * (1.0f / uv_unit_);
            a[at(has.uvs() + 1)] = vertices.v[vertex] * (1.0f / uv_unit_);
        }
        if constexpr (count > 3) a[at(has.q())] = 1.0f;
        return a;
    }

    Polygon polygon(std::size_t face, Side side) const {
        const mesh::Mesh& mesh = *placed_.mesh;
        Polygon polygon{placed_.material_of(face),
                        textures_[mesh.face_material[face]],
                        placed_.face_normal_seen(face, side),
                        face_steps(matrices_.object_from_screen, matrices_.world_from_screen,
                                   mesh.face_normals[face], mesh.face_offset[face]),
                        {},
                        side == Side::front ? 1.0f : -1.0f};
        if constexpr (has.has_uvs) {
            polygon.uvs = face_uvs(matrices_, mesh.face_normals[face], mesh.face_offset[face],
                                   mesh.face_u[face], mesh.face_v[face]);
        }
        return polygon;
    }

    /// What is to be lit.
    TexturedSurface<float> surface(const raster::Fragment<attribute_count>& fragment,
                                   const Polygon& polygon) const {
        const auto& a = fragment.attributes;
        const glm::vec3 screen = frame_.screen_at(fragment.x, fragment.y, fragment.depth);
        const glm::vec3 point = point_behind(frame_.world_from_screen, screen);
        const glm::vec3 normal = shading::unit_or(glm::vec3(a[0], a[1], a[2]), polygon.normal);
        const float inverse_w = 1.0f / point_component(frame_.world_from_screen, 3, screen);
        const glm::vec2 uv = own_uv(a);
        return {{point, normal, frame_.view_at(fragment.x, fragment.y)},
                {point, uv, uv_steps_at(polygon.uvs.steps, uv, inverse_w), polygon.uvs.gradients,
                 steps_at(polygon.steps, point, inverse_w)},
                color(a),
                polygon.outward};
    }

    raster::Rgba shade(const raster::Fragment<attribute_count>& fragment,
                       const Polygon& polygon) const {
        return textured_pixel(surface(fragment, polygon), polygon.material, polygon.textures,
                              frame_, settings_);
    }

private:
    using Values = std::array<float, attribute_count>;

    static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static void put(Values& a, int first, const glm::vec3& v) {
        for (int i = 0; i < 3; ++i)
            a[at(first + i)] = v[i];
    }

    static std::optional<glm::vec3> color(const Values& a) {
        if constexpr (!has.has_colors) return {};
        constexpr std::size_t c = at(has.colors());
        return undivided(glm::vec3(a[c], a[c + 1], a[c + 2]), a[at(has.q())]);
    }

    glm::vec2 own_uv(const Values& a) const {
        if constexpr (!has.has_uvs) return glm::vec2(0.0f);
        const glm::vec3 uv =
            undivided(glm::vec3(a[at(has.uvs())], a[at(has.uvs() + 1)], 0.0f), a[at(has.q())]);
        return {uv.x * uv_unit_, uv.y * uv_unit_};
    }

    const PlacedMesh& placed_;
    const Frame& frame_;
    const Settings& settings_;
    std::vector<PlacedTextures> textures_;
    float uv_unit_;
    FaceMatrices matrices_;
};

}  // namespace scanlight::render
