#include "raster/load_image.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "raster/decode_jpeg.h"
#include "raster/decode_png.h"
#include "raster/file_descriptor.h"
#include "raster/hdr.h"
#include "raster/image_error.h"
#include "raster/image_limits.h"
#include "raster/pfm.h"
#include "raster/pnm.h"

namespace scanlight::raster {

namespace {

[[noreturn]] void fail(const std::string& name, int error) {
    throw ImageError(name + ": cannot be read: " + std::generic_category().message(error));
}

FileDescriptor open_to_read(const std::string& path) {
    FileDescriptor file(uninterrupted([&] {
        return path == "-" ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    }));
    if (!file.is_open()) fail(path, errno);
    return file;
}

// Pipes and devices don't tell their size: memory is taken as bytes come, up to the limit.
Bytes read_to_end(const FileDescriptor& file, const std::string& name) {
    constexpr std::size_t step = std::size_t{1} << 18;
    Bytes bytes;
    for (;;) {
        const std::size_t size = bytes.size();
        if (size > max_file_bytes) throw ImageError(name + ": the file is too large");
        bytes.resize(size + step);
        const auto count =
            uninterrupted([&] { return ::read(file.get(), bytes.data() + size, step); });
        if (count < 0) fail(name, errno);
        bytes.resize(size + static_cast<std::size_t>(count));
        if (count == 0) return bytes;
    }
}

EncodedImage read_file(const std::string& path) {
    const FileDescriptor file = open_to_read(path);
    const std::string name = path == "-" ? "standard input" : path;
    return {name, read_to_end(file, name)};
}

std::string_view beginning(const EncodedImage& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

}  // namespace

AnyImage decode_image(const EncodedImage& file) {
    const std::string_view text = beginning(file);
    if (text.starts_with("\x89PNG")) return decode_png(file);
    if (text.starts_with("\xff\xd8\xff")) return decode_jpeg(file);
    if (text.starts_with("PF") || text.starts_with("Pf")) return decode_pfm(file);
    if (text.starts_with("#?")) return decode_hdr(file);
    if (text.size() > 1 && text[0] == 'P' && text[1] >= '1' && text[1] <= '7') {
        return decode_pnm(file);
    }
    throw ImageError(file.name + ": not a PNG, JPEG, PPM, PGM, PFM or Radiance HDR picture");
}

AnyImage load_image(const std::string& path) {
    return decode_image(read_file(path));
}

}  // namespace scanlight::raster
