#pragma once

#include <string>
#include <vector>

#include "mesh/build.h"

namespace scanlight::apps {

/// A mesh ready to draw, with what happened to it on the way.
struct Model {
    std::string name;  // as given
    mesh::Mesh mesh;
    mesh::BuildReport report;
    std::vector<std::string> warnings;
    double load_seconds = 0.0;
    double build_seconds = 0.0;
};

/// "cube, tetrahedron, …"
std::string shape_names();

/// `input` is a file, "-" for standard input, or a built-in shape: "teapot", "torus:48,24". A file
/// of that name comes first; "shape:teapot" is always the shape.
Model load_model(const std::string& input, const mesh::NormalRule& normals);

}  // namespace scanlight::apps
