#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scanlight::mesh {

enum class PlyEncoding { ascii, little_endian, big_endian };

/// The scalar types of PLY.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of one, in a binary file.
constexpr std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}
bool is_integer(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  // of a list's length
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;

    bool is_fixed_size() const;

    /// Bytes of the smallest record there is: every list empty; in text, "0" and a separator for
    /// each number.
    std::size_t smallest_record(PlyEncoding encoding) const;
};

/// What a PLY header (Turk 1994, "The PLY polygon file format") declares.
struct PlyHeader {
    PlyEncoding encoding;
    std::vector<PlyElement> elements;
    std::size_t size;  // bytes before the first record
};

/// Throws FileError "name:line: reason".
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace scanlight::mesh
