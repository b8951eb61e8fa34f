#pragma once

#include <string>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// Reads an OFF file (Geomview's object file format, text): OFF with any of the prefixes ST, C
/// and N, or no keyword at all. Colours of vertices and faces with a '.' or an exponent in one of
/// their numbers are linear, those without are sRGB, 0 to 255. `name` is for messages. Throws
/// FileError "name:line: reason".
PolygonSoup load_off(std::string_view bytes, const std::string& name);

}  // namespace scanlight::mesh
