#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "mesh/bounds.h"
#include "mesh/edges.h"
#include "mesh/mesh.h"

namespace scanlight::mesh {

/// Which side of a face a viewpoint sees.
enum class Facing : std::int8_t { back = -1, edge_on = 0, front = 1 };

/// An edge along which what a viewpoint sees of a mesh, and what it does not, meet.
struct SilhouetteEdge {
    std::uint32_t from, to;     // vertices
    std::int32_t multiplicity;  // how many faces go from `from` to `to`, less those that go back
};

struct Silhouette {
    std::vector<Facing> facing;  // of each face
    std::vector<SilhouetteEdge> edges;
};

/// Finds the silhouette of a mesh from any viewpoint. Keeps what does not depend on that: the
/// edges, and the planes of the faces. The mesh may go.
class SilhouetteFinder {
public:
    explicit SilhouetteFinder(const Mesh& mesh);

    /// Kim, Kim & Turk 2008, "A shadow volume algorithm for opaque and transparent non-manifold
    /// casters", journal of graphics, gpu, and game tools 13(3). Each face is turned so that the
    /// viewpoint sees its front; the faces' edges are added up with their directions. What does not
    /// cancel bounds them, on meshes of any kind: closed, open, with edges of three faces, with
    /// faces doubled or turned at random. On a closed mesh this is the classic silhouette, each
    /// edge twice: once for the faces towards the viewpoint and once for those behind them. Faces
    /// seen edge-on do not count. No edge of multiplicity 0.
    ///
    /// `viewpoint` is homogeneous, object space: a place (w = 1) or a direction towards it (w = 0).
    Silhouette from(const glm::dvec4& viewpoint) const;

    /// Of the mesh.
    const Box& bounds() const { return bounds_; }

private:
    /// Of a face: the area vector, and its product with a point; of a bent face with the mean of
    /// the corners.
    struct Plane {
        glm::dvec3 normal;
        double offset;
    };

    std::vector<Facing> facing(const glm::dvec4& viewpoint) const;

    Edges edges_;
    std::vector<Plane> planes_;
    Box bounds_;
};

}  // namespace scanlight::mesh
