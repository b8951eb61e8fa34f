#pragma once

#include <optional>
#include <string_view>

#include "mesh/cursor.h"
#include "mesh/texture_map.h"
#include "mesh/warnings.h"

namespace scanlight::mesh {

/// What stands after a map's statement.
struct MapArguments {
    TextureMap map;
    MapUse reflection = MapUse::sphere;  // -type, of refl
};

/// Reads options, in any order, and then a file's name, which goes on to the end of the line. Of an
/// option that may have fewer numbers than three, the last word of the line is none. Nothing, and a
/// warning, where no file is named or an option is unknown; FileError for an option's wrong value.
std::optional<MapArguments> read_texture_map(std::string_view statement, Cursor& text,
                                             Warnings& warnings);

}  // namespace scanlight::mesh
