#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/peers/stage.h"
#include "mesh/mesh.h"

namespace scanlight::peers {

/// How to come by a stage. Meshes that fill the picture depend on its aspect.
struct StagePlan {
    std::string name;
    View view;
    std::function<mesh::Mesh(double aspect)> mesh;
};

/// All that is drawn unless asked otherwise. Names that begin with "quads" are of quads, which
/// Scanlight draws by the edge table; all others are of triangles.
std::vector<StagePlan> usual_stages();

/// A mesh file, cut into triangles. Throws mesh::FileError when it is made.
StagePlan stage_from_file(const std::string& path);

}  // namespace scanlight::peers
