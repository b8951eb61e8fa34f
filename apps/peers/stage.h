#pragma once

#include <cstddef>

#include "apps/peers/coat.h"
#include "mesh/mesh.h"
#include "raster/project.h"
#include "render/scene.h"

namespace scanlight::peers {

/// From where a stage's mesh is looked at.
enum class View {
    framed,  // so that it just fits into the picture
    filled,  // from so near that a ball hides the whole background
    window,  // along -z, so that 1 to each side of the origin is the height of the picture
};

/// The distance of a `window` view from the origin.
double window_distance();

/// A mesh of one material under one directional light, before a camera.
/// Invariant: the scene shows `mesh()` and nothing else.
class Stage {
public:
    Stage(mesh::Mesh mesh, View view, raster::Viewport size);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void wear(Coat coat);

    const mesh::Mesh& mesh() const { return mesh_; }
    const render::Scene& scene() const { return scene_; }
    raster::Viewport size() const { return size_; }

private:
    mesh::Mesh mesh_;
    raster::Viewport size_;
    render::Scene scene_;
};

double aspect_of(raster::Viewport size);

/// Number of triangles when polygons are cut into them.
std::size_t triangle_count(const mesh::Mesh& mesh);

}  // namespace scanlight::peers
