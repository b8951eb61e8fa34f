#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/file_error.h"
#include "mesh/load_mtl.h"
#include "mesh/load_obj.h"
#include "mesh/load_off.h"
#include "mesh/load_ply.h"
#include "mesh/load_stl.h"

namespace scanlight::mesh {

inline std::optional<Bytes> no_library(std::string_view) {
    return std::nullopt;
}

/// Readers by the ending that names them; the file's name in messages is "file".
inline PolygonSoup read(std::string_view ending, std::string_view bytes) {
    if (ending == "obj") return load_obj(bytes, "file", no_library);
    if (ending == "ply") return load_ply(bytes, "file");
    if (ending == "off") return load_off(bytes, "file");
    if (ending == "stl") return load_stl(bytes, "file");
    PolygonSoup soup;
    soup.materials = load_mtl(bytes, "file").materials;
    return soup;
}

/// What the FileError says that `act` throws; empty if it throws none.
template <class Act>
std::string error_of(Act&& act) {
    try {
        act();
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

inline std::string read_error(std::string_view ending, std::string_view bytes) {
    return error_of([&] { read(ending, bytes); });
}

/// A file, and what its reader must say of it.
struct BadFile {
    std::string bytes;
    std::string message;
};

template <class Number>
std::string bytes_of_number(Number number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
}

/// A binary STL triangle on a little-endian machine.
inline std::string stl_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    std::string bytes;
    for (const glm::vec3& v : {glm::vec3(0, 0, 1), a, b, c}) {
        bytes += bytes_of_number(v.x) + bytes_of_number(v.y) + bytes_of_number(v.z);
    }
    return bytes + std::string(2, '\7');
}

inline std::string binary_stl(std::uint32_t declared, const std::string& triangles,
                              std::string header = {}) {
    header.resize(80, '\0');
    return header + bytes_of_number(declared) + triangles;
}

inline const std::string ply_points =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
inline const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n";
inline const std::string ply_triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
inline const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

inline std::string text_ply(const std::string& declarations, const std::string& body) {
    return "ply\nformat ascii 1.0\n" + declarations + "end_header\n" + body;
}

}  // namespace scanlight::mesh
