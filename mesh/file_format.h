#pragma once

#include <optional>
#include <string_view>

namespace scanlight::mesh {

enum class FileFormat { obj, ply, off, stl };

/// Told by the content, which knows best; failing that, by the ending of `path`, in any case of
/// letters. Nothing if neither tells.
std::optional<FileFormat> format_of(std::string_view bytes, std::string_view path);

}  // namespace scanlight::mesh
