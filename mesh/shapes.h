#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

struct ShapeInfo {
    std::string name;
    std::string parameters;  // "level (0 to 8, default 3)"; empty when it takes none
};

/// All built-in shapes, for `--help` and messages.
std::vector<ShapeInfo> list_shapes();

/// Whether `text` names a built-in shape, with or without parameters: "torus", "torus:48,24".
/// The parameters are not looked at.
bool is_shape(std::string_view text);

/// Builds a shape from "name" or "name:number[,number]", such as "teapot:8" or "torus:48,24", or
/// from its corners, "polygon:0,1:-1,-1:1,-1". Shapes lie about the origin and fit into [-2, 2],
/// but a polygon has the corners that it is given; y is up; faces turn counter-clockwise seen from
/// outside (from +y or +z for the flat ones).
/// Throws FileError for an unknown name (it names the nearest one) or parameters that do not do.
PolygonSoup shape(std::string_view text);

}  // namespace scanlight::mesh
