#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh_folder.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Reads a Wavefront OBJ file: v (with optional colours, taken as linear), vt, vn, f with any
/// number of corners, usemtl and mtllib. Free-form surfaces, groups and smoothing are passed over.
/// `name` is for messages; `open` opens material libraries. A missing library is a warning, one
/// that must not be read an error. Throws FileError "name:line: reason".
PolygonSoup load_obj(std::string_view bytes, const std::string& name, const OpenFile& open);

}  // namespace scanlight::mesh
