#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace scanlight::mesh {

/// No larger file is read. Every corner, point and face takes at least one byte of its file, so
/// below this bound none of their counts can leave 32 bits.
inline constexpr std::size_t max_file_bytes = std::size_t{1} << 31;

/// The bytes of one file, read once: a file that changes or shrinks meanwhile can do no harm.
class Bytes {
public:
    Bytes() = default;
    Bytes(std::unique_ptr<char[]> data, std::size_t size) : data_(std::move(data)), size_(size) {}
    std::string_view view() const { return {data_.get(), size_}; }

private:
    std::unique_ptr<char[]> data_;
    std::size_t size_ = 0;
};

/// How messages call the file at `path`.
std::string display_name(const std::string& path);

/// All bytes of a regular file or pipe; "-" is standard input. Throws FileError for anything else
/// (a folder, a device, a terminal), for more than `max_file_bytes`, and when reading fails.
Bytes read_input(const std::string& path);

/// All bytes of a regular file; the same errors, with another bound on its size perhaps, and pipes
/// are refused too.
Bytes read_regular_file(const std::string& path, std::size_t most_bytes = max_file_bytes);

}  // namespace scanlight::mesh
