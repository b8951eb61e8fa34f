#include "mesh/normals.h"

#include <algorithm>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/half_edge.h"
#include "mesh/newell.h"
#include "mesh/trigonometry.h"

namespace scanlight::mesh {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// A weighted sum of unit normals, with the sum of their weights.
struct NormalSum {
    glm::dvec3 value{0.0};
    double weight = 0.0;

    /// Weights have any scale that areas of float coordinates have: the squares stay finite.
    bool vanishes() const { return glm::length(value) <= 1e-9 * weight; }
};

std::vector<double> face_areas(const PolygonSoup& soup, const Polygons& polygons) {
    std::vector<double> areas(polygons.face_count());
    std::vector<glm::vec3> shape;
    for (std::size_t face = 0; face < areas.size(); ++face) {
        shape.clear();
        for (std::uint32_t c = polygons.begin[face]; c < polygons.begin[face + 1]; ++c) {
            shape.push_back(soup.positions[polygons.point[c]]);
        }
        areas[face] = glm::length(area_vector(shape));
    }
    return areas;
}

/// The inner angle of the half-edge's face where it begins, 0 to 2 pi.
double angle_at(const Connectivity& surface, HalfedgeHandle leaving) {
    const glm::dvec3 here = point(surface, surface.from_vertex_handle(leaving));
    const HalfedgeHandle entering = surface.prev_halfedge_handle(leaving);
    const glm::dvec3 after = point(surface, surface.to_vertex_handle(leaving)) - here;
    const glm::dvec3 before = point(surface, surface.from_vertex_handle(entering)) - here;
    const glm::dvec3 axis = normal(surface, surface.face_handle(leaving));
    return angle_of(glm::dot(glm::cross(after, before), axis), glm::dot(after, before));
}

/// The faces around a vertex, counter-clockwise, each as the half-edge that leaves the vertex into
/// it.
struct Ring {
    std::vector<HalfedgeHandle> sectors;
    std::vector<char>
        ends;              // one a sector: a crease or the rim of the surface comes before the next
    bool creased = false;  // some end is a crease

    void clear() {
        sectors.clear();
        ends.clear();
        creased = false;
    }

    /// Turns the ring until it begins behind an end; there must be one.
    void begin_behind_end() {
        const auto end = std::ranges::find(ends, true) - ends.begin();
        std::rotate(sectors.begin(), sectors.begin() + end + 1, sectors.end());
        std::rotate(ends.begin(), ends.begin() + end + 1, ends.end());
    }
};

class Smoother {
public:
    Smoother(const PolygonSoup& soup, const HalfEdgeMesh& mesh, const NormalRule& rule)
        : mesh_(mesh), rule_(rule), normals_(mesh.polygons.corner_count()) {
        if (rule.weight == NormalWeight::area) areas_ = face_areas(soup, mesh.polygons);
        // With some room for rounding: an edge of exactly this angle is smooth.
        cos_crease_ = cosine(rule.crease_deg * (pi / 180.0)) - 1e-12;
    }

    std::vector<glm::vec3> run() && {
        for (const auto vertex : surface().vertices()) {
            smooth(vertex);
        }
        return std::move(normals_);
    }

private:
    const Connectivity& surface() const { return mesh_.surface; }

    void smooth(VertexHandle vertex) {
        gather_ring(vertex);
        if (!ring_.creased) {
            assign(ring_.sectors, whole_sum(vertex));
            return;
        }
        ring_.begin_behind_end();
        for (std::size_t begin = 0, end = 0; begin < ring_.sectors.size(); begin = end) {
            do
                ++end;
            while (!ring_.ends[end - 1]);
            const std::span sectors = std::span(ring_.sectors).subspan(begin, end - begin);
            assign(sectors, sum_of(sectors));
        }
    }

    void gather_ring(VertexHandle vertex) {
        ring_.clear();
        const HalfedgeHandle first = surface().halfedge_handle(vertex);
        if (!first.is_valid()) return;
        HalfedgeHandle leaving = first;
        do {
            const HalfedgeHandle entering = surface().prev_halfedge_handle(leaving);
            if (!surface().is_boundary(leaving))
                add_sector(leaving, surface().edge_handle(entering));
            leaving = surface().opposite_halfedge_handle(entering);
        } while (leaving != first);
    }

    void add_sector(HalfedgeHandle leaving, EdgeHandle last) {
        const bool crease = is_crease(last);
        ring_.sectors.push_back(leaving);
        ring_.ends.push_back(crease || surface().is_boundary(last));
        ring_.creased = ring_.creased || crease;
    }

    bool is_crease(EdgeHandle edge) const {
        if (rule_.crease_deg >= 180.0f || surface().is_boundary(edge)) return false;
        const FaceHandle a = surface().face_handle(surface().halfedge_handle(edge, 0));
        const FaceHandle b = surface().face_handle(surface().halfedge_handle(edge, 1));
        return glm::dot(normal(surface(), a), normal(surface(), b)) < cos_crease_;
    }

    /// Around a vertex without creases. The mean is OpenMesh's own.
    NormalSum whole_sum(VertexHandle vertex) const {
        if (rule_.weight == NormalWeight::area || rule_.weight == NormalWeight::angle) {
            return sum_of(ring_.sectors);
        }
        OpenMesh::Vec3d sum;
        surface().calc_vertex_normal_fast(vertex, sum);
        return {{sum[0], sum[1], sum[2]}, static_cast<double>(ring_.sectors.size())};
    }

    NormalSum sum_of(std::span<const HalfedgeHandle> sectors) const {
        NormalSum sum;
        for (const HalfedgeHandle sector : sectors) {
            const double weight = weight_of(sector);
            sum.value += weight * normal(surface(), surface().face_handle(sector));
            sum.weight += weight;
        }
        return sum;
    }

    double weight_of(HalfedgeHandle sector) const {
        switch (rule_.weight) {
            case NormalWeight::area:
                return areas_[static_cast<std::size_t>(surface().face_handle(sector).idx())];
            case NormalWeight::angle:
                return angle_at(surface(), sector);
            case NormalWeight::mean:
            case NormalWeight::file:
                break;
        }
        return 1.0;
    }

    void assign(std::span<const HalfedgeHandle> sectors, const NormalSum& sum) {
        const bool vanishes = sum.vanishes();
        const glm::vec3 shared = unit_or_zero(sum.value);
        for (const HalfedgeHandle sector : sectors) {
            normals_[surface().data(sector).corner] =
                vanishes ? glm::vec3(normal(surface(), surface().face_handle(sector))) : shared;
        }
    }

    const HalfEdgeMesh& mesh_;
    NormalRule rule_;
    double cos_crease_ = 0.0;
    std::vector<double> areas_;  // one a face, when they weigh
    Ring ring_;                  // of the vertex at hand
    std::vector<glm::vec3> normals_;
};

void take_from_file(const PolygonSoup& soup, const Polygons& polygons,
                    std::vector<glm::vec3>& normals) {
    for (std::uint32_t i = 0; i < normals.size(); ++i) {
        const std::uint32_t given = soup.corners[polygons.soup_corner(i)].normal;
        if (given == PolygonSoup::none) continue;
        const glm::dvec3 unit = unit_or_zero(soup.normals[given]);
        if (unit != glm::dvec3(0.0)) normals[i] = unit;
    }
}

}  // namespace

std::vector<glm::vec3> corner_normals(const PolygonSoup& soup, const HalfEdgeMesh& mesh,
                                      const NormalRule& rule) {
    std::vector<glm::vec3> normals = Smoother(soup, mesh, rule).run();
    if (rule.weight == NormalWeight::file) take_from_file(soup, mesh.polygons, normals);
    return normals;
}

}  // namespace scanlight::mesh
