#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/cursor.h"
#include "mesh/load_mtl.h"
#include "mesh/material_table.h"
#include "mesh/mesh_folder.h"
#include "mesh/polygon_soup.h"

namespace scanlight::mesh {

/// The materials of an OBJ file: which libraries it names, which material its faces take.
/// Invariant: `face_material_` has one entry for each face so far.
class ObjMaterials {
public:
    /// `name` is the file's, for messages.
    ObjMaterials(std::string name, const OpenFile& open) : name_(std::move(name)), open_(open) {}

    /// The faces to come take the material of this name, defined or not.
    void use(std::string_view name);

    void add_face();

    /// Reads what an mtllib statement names: one file with blanks in its name, or several without.
    /// `text` stands on the statement's line. A missing library is a warning; FileError for one
    /// that must not be read, is malformed, or is one too many.
    void read_libraries(std::string_view names, const Cursor& text);

    /// Hands materials and warnings over; a file that names no material has none.
    void give_to(PolygonSoup& soup) &&;

private:
    bool read_library(std::string_view name, const Cursor& text);
    std::optional<Bytes> open_library(std::string_view name, const Cursor& text);
    void warn(const std::string& what);
    void warn_of_missing(std::string_view name, const Cursor& text);
    void add(MaterialLibrary library);
    void warn_of_undefined();

    std::string name_;
    const OpenFile& open_;
    MaterialTable table_;
    std::set<std::string, std::less<>> tried_;  // libraries, there or not
    std::optional<std::uint32_t> current_;
    bool any_named_ = false;
    std::vector<std::uint32_t> face_material_;
    std::vector<std::string> warnings_;
};

}  // namespace scanlight::mesh
