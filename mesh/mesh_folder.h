#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/input.h"

namespace scanlight::mesh {

/// Opens a file by the name that a mesh file or a material library gives it: nothing when there is
/// no such file, FileError when it must not be read.
using OpenFile = std::function<std::optional<Bytes>(std::string_view name)>;

/// What the files are that are asked for, and how large they may be.
struct FileKind {
    std::string name;  // for messages: "material library"
    std::size_t most_bytes = max_file_bytes;
};

/// Why a file of this name is refused whatever the disk holds: an absolute path, a drive, a ".."
/// step, nothing at all. Empty when it isn't. A mesh file has no business outside its folder.
std::string_view reason_to_refuse(std::string_view name);

/// Opens files in the folder of `mesh_path` or below it; regular files only, and no link that leads
/// out. Standard input ("-") has no folder: nothing is found.
OpenFile files_beside(const std::string& mesh_path, const FileKind& kind);

}  // namespace scanlight::mesh
