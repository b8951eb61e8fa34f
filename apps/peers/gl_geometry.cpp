#include "apps/peers/gl_geometry.h"

#include <cstddef>
#include <span>

namespace scanlight::peers {

namespace {

void append(std::vector<float>& numbers, const glm::vec3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

void overwrite(std::span<float> numbers, const glm::vec3& v) {
    numbers[0] = v.x;
    numbers[1] = v.y;
    numbers[2] = v.z;
}

glm::vec3 mean_corner(const mesh::Mesh& mesh, std::span<const std::uint32_t> face) {
    glm::vec3 sum(0.0f);
    for (const std::uint32_t vertex : face)
        sum += mesh.vertices.position(vertex);
    return sum / static_cast<float>(face.size());
}

/// Triangles around corner `tip`, which each of them has for its last; `last` stands in for it.
void append_fan(std::vector<std::uint32_t>& corners, std::span<const std::uint32_t> face,
                std::size_t tip, std::uint32_t last) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        corners.insert(corners.end(),
                       {face[(tip + i) % face.size()], face[(tip + i + 1) % face.size()], last});
    }
}

GlGeometry vertices_of(const mesh::Mesh& mesh, int attributes) {
    GlGeometry geometry{attributes, {}, {}};
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        append(geometry.numbers, mesh.vertices.position(i));
        append(geometry.numbers, mesh.vertices.normal(i));
        if (attributes == 3) append(geometry.numbers, glm::vec3(0.0f));
    }
    return geometry;
}

void append_fans(GlGeometry& geometry, const mesh::Mesh& mesh) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        append_fan(geometry.corners, mesh.face(f), 0, mesh.face(f)[0]);
}

/// Gives each polygon a vertex that speaks for it.
class Speakers {
public:
    Speakers(const mesh::Mesh& mesh, GlGeometry& geometry)
        : mesh_(mesh), geometry_(geometry), taken_(mesh.vertices.size(), false) {}

    void add(std::size_t f) {
        const auto face = mesh_.face(f);
        std::size_t tip = 0;
        while (tip < face.size() && taken_[face[tip]])
            ++tip;
        if (tip == face.size()) tip = 0;
        const std::uint32_t speaker = taken_[face[tip]] ? doubled(face[tip]) : face[tip];
        taken_[face[tip]] = true;
        const auto row = std::span(geometry_.numbers).subspan(std::size_t{9} * speaker);
        overwrite(row.subspan(3), mesh_.face_normals[f]);
        overwrite(row.subspan(6), mean_corner(mesh_, face));
        append_fan(geometry_.corners, face, tip, speaker);
    }

private:
    std::uint32_t doubled(std::uint32_t vertex) {
        const auto number = static_cast<std::uint32_t>(geometry_.numbers.size() / 9);
        append(geometry_.numbers, mesh_.vertices.position(vertex));
        geometry_.numbers.resize(geometry_.numbers.size() + 6);
        return number;
    }

    const mesh::Mesh& mesh_;
    GlGeometry& geometry_;
    std::vector<bool> taken_;
};

}  // namespace

GlGeometry smooth_geometry(const mesh::Mesh& mesh) {
    GlGeometry geometry = vertices_of(mesh, 2);
    append_fans(geometry, mesh);
    return geometry;
}

GlGeometry mapped_geometry(const mesh::Mesh& mesh) {
    GlGeometry geometry = vertices_of(mesh, 3);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        overwrite(std::span(geometry.numbers).subspan(9 * i + 6),
                  {mesh.vertices.u[i], mesh.vertices.v[i], 0.0f});
    }
    append_fans(geometry, mesh);
    return geometry;
}

GlGeometry flat_geometry(const mesh::Mesh& mesh) {
    GlGeometry geometry = vertices_of(mesh, 3);
    Speakers speakers(mesh, geometry);
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        speakers.add(f);
    return geometry;
}

}  // namespace scanlight::peers
