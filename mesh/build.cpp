#include "mesh/build.h"

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

}  // namespace

BuiltMesh build(const PolygonSoup& soup, const NormalRule& rule) {
    const HalfEdgeMesh mesh = half_edge_mesh(soup);
    const std::vector<glm::vec3> normals = corner_normals(soup, mesh, rule);
    return {flatten(soup, mesh.polygons, normals), report_on(soup, mesh)};
}

}  // namespace scanlight::mesh
