#include "mesh/mesh_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "mesh/file_error.h"
#include "mesh/text.h"

namespace scanlight::mesh {
namespace {

namespace fs = std::filesystem;

/// Exporters on Windows write back slashes.
std::string with_slashes(std::string_view name) {
    std::string result(name);
    std::ranges::replace(result, '\\', '/');
    return result;
}

bool has_parent_step(const fs::path& path) {
    return std::ranges::any_of(path, [](const fs::path& step) { return step == ".."; });
}

bool lies_in(const fs::path& folder, const fs::path& path) {
    return std::ranges::mismatch(folder, path).in1 == folder.end();
}

fs::path folder_of(const std::string& mesh_path) {
    return fs::weakly_canonical(fs::absolute(mesh_path).parent_path());
}

[[noreturn]] void refuse(const FileKind& kind, std::string_view name, std::string_view reason) {
    throw FileError(kind.name + " " + quoted(name) + " is refused: " + std::string(reason));
}

std::optional<Bytes> open_beside(const fs::path& folder, const FileKind& kind,
                                 std::string_view name) {
    const std::string_view reason = reason_to_refuse(name);
    if (!reason.empty()) refuse(kind, name, reason);
    std::error_code error;
    const fs::path path = fs::canonical(folder / with_slashes(name), error);
    if (error) return std::nullopt;
    if (!lies_in(folder, path))
        refuse(kind, name, "it is a link that leads out of the file's folder");
    return read_regular_file(path.string(), kind.most_bytes);
}

}  // namespace

std::string_view reason_to_refuse(std::string_view name) {
    const fs::path path = with_slashes(name);
    if (name.empty()) return "it has no name";
    if (name.find('\0') != name.npos) return "its name holds a zero byte";
    if (path.is_absolute()) return "it is an absolute path";
    if (name.size() > 1 && name[1] == ':') return "it names a drive";
    if (has_parent_step(path)) return "it lies outside the file's folder";
    return {};
}

OpenFile files_beside(const std::string& mesh_path, const FileKind& kind) {
    if (mesh_path == "-") return [](std::string_view) { return std::nullopt; };
    return [folder = folder_of(mesh_path), kind](std::string_view name) {
        return open_beside(folder, kind, name);
    };
}

}  // namespace scanlight::mesh
