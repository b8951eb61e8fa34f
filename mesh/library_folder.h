#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/input.h"

namespace scanlight::mesh {

/// Opens a material library by the name an OBJ file gives it: nothing when there is no such file,
/// FileError when it must not be read.
using OpenLibrary = std::function<std::optional<Bytes>(std::string_view name)>;

/// Why a library of this name is refused whatever the disk holds: an absolute path, a drive, a
/// ".." step, nothing at all. Empty when it isn't. A mesh file has no business outside its folder.
std::string_view reason_to_refuse(std::string_view name);

/// Opens libraries in the folder of `mesh_path` or below it; regular files only, and no link that
/// leads out. Standard input ("-") has no folder: nothing is found.
OpenLibrary libraries_beside(const std::string& mesh_path);

}  // namespace scanlight::mesh
