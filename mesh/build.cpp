#include "mesh/build.h"

#include <utility>

#include "mesh/flatten.h"
#include "mesh/half_edge.h"

namespace scanlight::mesh {
namespace {

BuildReport report_on(const PolygonSoup& soup, const HalfEdgeMesh& mesh) {
    return {
        .faces_in = soup.face_count(),
        .drawn = mesh.polygons.face_count(),
        .zero_area = mesh.polygons.zero_area,
        .few_corners = mesh.polygons.few_corners,
        .split_faces = mesh.split_faces,
        .split_vertices = mesh.split_vertices,
        .isolated_points = mesh.isolated_points,
        .vertices = mesh.surface.n_vertices(),
        .edges = mesh.surface.n_edges(),
        .boundary_edges = count_boundary_edges(mesh),
        .components = count_components(mesh),
    };
}

/// What is left of the half-edge mesh when its memory is given back.
struct Smoothed {
    Polygons polygons;
    Normals normals;
    BuildReport report;
};

Smoothed smoothed(const PolygonSoup& soup, const NormalRule& rule) {
    HalfEdgeMesh mesh = half_edge_mesh(soup);
    const BuildReport report = report_on(soup, mesh);
    Normals normals{corner_normals(soup, mesh, rule), face_normals(mesh)};
    return {std::move(mesh.polygons), std::move(normals), report};
}

}  // namespace

BuiltMesh build(const PolygonSoup& soup, const NormalRule& rule) {
    Smoothed surface = smoothed(soup, rule);
    return {flatten(soup, std::move(surface.polygons), std::move(surface.normals)), surface.report};
}

}  // namespace scanlight::mesh
