#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/silhouette.h"
#include "raster/project.h"
#include "render/scene.h"

namespace scanlight::peers {

/// A closed mesh over a floor, in one directional light.
class ShadowStage {
public:
    ShadowStage(mesh::Mesh caster, raster::Viewport size);
    ShadowStage(const ShadowStage&) = delete;
    ShadowStage& operator=(const ShadowStage&) = delete;

    const mesh::Mesh& caster() const { return caster_; }
    const mesh::Mesh& floor() const { return floor_; }
    const mesh::SilhouetteFinder& silhouettes() const { return silhouettes_; }
    const render::Scene& scene() const { return scene_; }
    raster::Viewport size() const { return size_; }

private:
    mesh::Mesh caster_, floor_;
    mesh::SilhouetteFinder silhouettes_, floor_silhouettes_;
    raster::Viewport size_;
    render::Scene scene_;
};

struct ShadowStagePlan {
    std::string name;
    std::function<mesh::Mesh()> caster;
};

/// A teapot, and displaced spheres of 70,000 and 100,000 triangles.
std::vector<ShadowStagePlan> shadow_stages();

}  // namespace scanlight::peers
