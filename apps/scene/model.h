#pragma once

#include <string>
#include <vector>

#include "mesh/bounds.h"
#include "mesh/build.h"
#include "shading/surface_textures.h"

namespace scanlight::apps {

/// A mesh ready to draw, with what happened to it on the way.
struct Model {
    std::string name;  // as given
    mesh::Mesh mesh;
    std::vector<shading::SurfaceTextures> textures;  // its materials' own; empty if there are none
    mesh::BuildReport report;
    std::vector<std::string> warnings;  // the reader's, and of normals that are missing
    double load_seconds = 0.0;
    double build_seconds = 0.0;
};

/// For a person: the reader's warnings, and how many faces were left out.
std::vector<std::string> warnings_of(const Model& model);

/// "cube, tetrahedron, …"
std::string shape_names();

/// A square in the plane y = bottom of the box, with the box over its middle and four times as
/// wide.
mesh::Mesh floor_beneath(const mesh::Box& box);

/// Whether `input` means a built-in shape rather than a file.
bool names_shape(const std::string& input);

/// `input` is a file, "-" for standard input, or a built-in shape: "teapot", "torus:48,24". A file
/// of that name comes first; "shape:teapot" is always the shape.
/// Where the file's own normals are asked for and missing, a warning says what stands in for them.
Model load_model(const std::string& input, const mesh::NormalRule& normals);

}  // namespace scanlight::apps
