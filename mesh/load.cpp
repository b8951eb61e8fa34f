#include "mesh/load.h"

#include <new>
#include <optional>

#include "mesh/file_error.h"
#include "mesh/file_format.h"
#include "mesh/input.h"
#include "mesh/load_obj.h"
#include "mesh/load_off.h"
#include "mesh/load_ply.h"
#include "mesh/load_stl.h"
#include "mesh/mesh_folder.h"

namespace scanlight::mesh {
namespace {

PolygonSoup load_bytes(std::string_view bytes, const std::string& path) {
    const std::string name = display_name(path);
    if (bytes.empty()) throw FileError(name + ": is empty");
    const std::optional<FileFormat> format = format_of(bytes, path);
    if (!format) throw FileError(name + ": is neither OBJ, PLY, OFF nor STL");
    switch (*format) {
        case FileFormat::obj:
            return load_obj(bytes, name, files_beside(path, {"material library"}));
        case FileFormat::ply:
            return load_ply(bytes, name);
        case FileFormat::off:
            return load_off(bytes, name);
        case FileFormat::stl:
            break;
    }
    return load_stl(bytes, name);
}

}  // namespace

PolygonSoup load(const std::string& path) {
    try {
        const Bytes bytes = read_input(path);
        return load_bytes(bytes.view(), path);
    } catch (const std::bad_alloc&) {
        throw FileError(display_name(path) + ": takes more memory than there is");
    }
}

}  // namespace scanlight::mesh
