#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scanlight::raster {

/// Writes a file whole or not at all: into a temporary file in the same folder, to the disk, then
/// over the old one in one step. Whatever happens, power loss and SIGKILL included, `path` holds
/// the old bytes or the new; when writing fails, no temporary file stays.
///
/// A new file gets the mode that umask leaves of 0666, a replaced one keeps its mode; a file that
/// may not be written is not replaced; a symbolic link stays and its target is replaced; a hard
/// link is broken. Devices, pipes and, for "-", standard output are written in place.
///
/// Throws ImageError "path: reason", also for a closed pipe, which raises no SIGPIPE here.
void save_file(const std::string& path, std::span<const std::uint8_t> bytes);
void save_file(const std::string& path, std::string_view text);

}  // namespace scanlight::raster
