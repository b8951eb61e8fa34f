#include "mesh/obj_materials.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "mesh/file_error.h"

namespace scanlight::mesh {
namespace {

constexpr std::size_t max_libraries = 64;
constexpr std::size_t max_undefined_listed = 20;

}  // namespace

void ObjMaterials::use(std::string_view name) {
    current_ = table_.index_of(name);
    any_named_ = true;
}

void ObjMaterials::add_face() {
    if (!current_) {  // the default material; a name in a file is never empty
        table_.define(Material{});
        current_ = table_.index_of("");
    }
    face_material_.push_back(*current_);
}

void ObjMaterials::read_libraries(std::string_view names, const Cursor& text) {
    if (tried_.contains(names) || read_library(names, text)) return;
    if (std::ranges::none_of(names, is_blank)) return warn_of_missing(names, text);
    Cursor list(names, text.name());
    while (!list.at_line_end()) {
        const std::string_view name = list.word();
        if (!tried_.contains(name) && !read_library(name, text)) warn_of_missing(name, text);
    }
}

/// False if there is no such library. Each is tried once, however often it is named.
bool ObjMaterials::read_library(std::string_view name, const Cursor& text) {
    if (tried_.size() == max_libraries) text.fail("one material library too many");
    tried_.emplace(name);
    const std::optional<Bytes> bytes = open_library(name, text);
    if (bytes) add(load_mtl(bytes->view(), std::string(name)));
    return bytes.has_value();
}

std::optional<Bytes> ObjMaterials::open_library(std::string_view name, const Cursor& text) {
    try {
        return open_(name);
    } catch (const FileError& error) {
        text.fail(error.what());
    }
}

void ObjMaterials::warn(const std::string& what) {
    warnings_.push_back(name_ + ": " + what);
}

void ObjMaterials::warn_of_missing(std::string_view name, const Cursor& text) {
    warnings_.push_back(text.where() + ": material library " + quoted(name) +
                        " is not there: default materials take its place");
}

void ObjMaterials::add(MaterialLibrary library) {
    std::ranges::move(library.warnings, std::back_inserter(warnings_));
    const auto repeated = std::ranges::count_if(
        library.materials, [&](const Material& material) { return !table_.define(material); });
    if (repeated > 0) {
        warn(counted(static_cast<std::size_t>(repeated), "material is", "materials are") +
             " defined again: the first of a name is taken");
    }
}

void ObjMaterials::give_to(PolygonSoup& soup) && {
    if (any_named_) {
        warn_of_undefined();
        soup.face_material = std::move(face_material_);
        soup.materials = std::move(table_).take();
    }
    std::ranges::move(warnings_, std::back_inserter(soup.warnings));
}

void ObjMaterials::warn_of_undefined() {
    const std::vector<std::string> names = table_.undefined();
    for (std::size_t i = 0; i < std::min(names.size(), max_undefined_listed); ++i) {
        warn("material " + quoted(names[i]) + " is not defined: a default one takes its place");
    }
    if (names.size() > max_undefined_listed) {
        warn(std::to_string(names.size()) + " materials in all are not defined");
    }
}

}  // namespace scanlight::mesh
