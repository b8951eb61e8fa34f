#include "mesh/flatten.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesh/face_planes.h"
#include "mesh/group.h"
#include "mesh/polygons.h"

namespace scanlight::mesh {
namespace {

class Flattener {
public:
    Flattener(const PolygonSoup& soup, Polygons polygons, Normals normals)
        : soup_(soup), polygons_(std::move(polygons)), normals_(std::move(normals)) {}

    Mesh run() && {
        copy_materials();
        note_corner_materials();
        mesh_.corners = first_equals();
        number_vertices();
        move_faces();
        find_face_planes(mesh_);
        return std::move(mesh_);
    }

private:
    glm::vec2 uv(std::uint32_t corner) const {
        const std::uint32_t index = soup_.corners[polygons_.soup_corner(corner)].uv;
        return index == PolygonSoup::none ? glm::vec2(0.0f) : soup_.uvs[index];
    }

    std::uint32_t material(std::uint32_t corner) const {
        return corner_material_.empty() ? 0 : corner_material_[corner];
    }

    /// What tells apart the vertices of one point.
    std::tuple<float, float, float, float, float, std::uint32_t> key(std::uint32_t corner) const {
        const glm::vec3& n = normals_.corners[corner];
        const glm::vec2 t = uv(corner);
        return {n.x, n.y, n.z, t.x, t.y, material(corner)};
    }

    /// For every corner the first corner that is the same vertex.
    std::vector<std::uint32_t> first_equals() const {
        std::vector<std::uint32_t> first(polygons_.corner_count());
        Groups at_point = group_by(polygons_.point, soup_.positions.size());
        for (std::size_t point = 0; point < at_point.size(); ++point) {
            note_first_equals(at_point[point], first);
        }
        return first;
    }

    void note_first_equals(std::span<std::uint32_t> corners,
                           std::vector<std::uint32_t>& first) const {
        if (corners.empty()) return;
        const auto differs = [this, k = key(corners[0])](std::uint32_t c) { return key(c) != k; };
        if (std::ranges::any_of(corners, differs)) {
            std::ranges::sort(corners, {},
                              [this](std::uint32_t c) { return std::pair(key(c), c); });
        }
        std::uint32_t leader = corners[0];
        for (const std::uint32_t corner : corners) {
            if (key(corner) != key(leader)) leader = corner;
            first[corner] = leader;
        }
    }

    /// Turns first equal corners into vertices.
    void number_vertices() {
        for (std::uint32_t corner = 0; corner < mesh_.corners.size(); ++corner) {
            std::uint32_t& index = mesh_.corners[corner];
            if (index != corner) {
                index = mesh_.corners[index];
                continue;
            }
            index = static_cast<std::uint32_t>(mesh_.vertices.size());
            add_vertex(corner);
        }
    }

    void add_vertex(std::uint32_t corner) {
        Vertices& out = mesh_.vertices;
        const glm::vec3& p = soup_.positions[polygons_.point[corner]];
        const glm::vec3& n = normals_.corners[corner];
        out.x.push_back(p.x), out.y.push_back(p.y), out.z.push_back(p.z);
        out.nx.push_back(n.x), out.ny.push_back(n.y), out.nz.push_back(n.z);
        if (!soup_.uvs.empty()) {
            const glm::vec2 t = uv(corner);
            out.u.push_back(t.x), out.v.push_back(t.y);
        }
        if (!soup_.colors.empty()) {
            const glm::vec3& c = soup_.colors[polygons_.point[corner]];
            out.red.push_back(c.r), out.green.push_back(c.g), out.blue.push_back(c.b);
        }
    }

    void move_faces() {
        mesh_.face_begin = std::move(polygons_.begin);
        mesh_.face_id = std::move(polygons_.soup_face);
        mesh_.face_normals = std::move(normals_.faces);
    }

    void copy_materials() {
        mesh_.materials = soup_.materials;
        if (mesh_.materials.empty()) mesh_.materials.emplace_back();
        mesh_.face_material.assign(polygons_.face_count(), 0);
        if (soup_.face_material.empty()) return;
        for (std::size_t face = 0; face < polygons_.face_count(); ++face) {
            mesh_.face_material[face] = soup_.face_material[polygons_.soup_face[face]];
        }
    }

    void note_corner_materials() {
        if (mesh_.materials.size() == 1) return;
        corner_material_.resize(polygons_.corner_count());
        for (std::size_t face = 0; face < polygons_.face_count(); ++face) {
            const auto first = corner_material_.begin();
            std::fill(first + polygons_.begin[face], first + polygons_.begin[face + 1],
                      mesh_.face_material[face]);
        }
    }

    const PolygonSoup& soup_;
    Polygons polygons_;
    Normals normals_;
    std::vector<std::uint32_t> corner_material_;  // empty: all corners have the same
    Mesh mesh_;
};

}  // namespace

Mesh flatten(const PolygonSoup& soup, Polygons polygons, Normals normals) {
    return Flattener(soup, std::move(polygons), std::move(normals)).run();
}

}  // namespace scanlight::mesh
