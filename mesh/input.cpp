#include "mesh/input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "mesh/file_error.h"

namespace scanlight::mesh {
namespace {

/// Owns an open file, unless it is standard input.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ > STDIN_FILENO) ::close(number_);
    }
    int number() const { return number_; }

private:
    int number_;
};

enum class Accept { files, files_and_pipes };

/// What is read, and how much of it.
struct Rules {
    Accept accept;
    std::size_t most_bytes = max_file_bytes;
};

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
    throw FileError(name + ": " + reason);
}

[[noreturn]] void fail_with_errno(const std::string& name, const std::string& reason) {
    fail(name, reason + ": " + std::generic_category().message(errno));
}

void expect_kind(mode_t mode, Accept accept, const std::string& name) {
    if (S_ISREG(mode)) return;
    const bool pipe = S_ISFIFO(mode) || S_ISSOCK(mode);
    if (pipe && accept == Accept::files_and_pipes) return;
    if (S_ISDIR(mode)) fail(name, "is a folder");
    if (pipe) fail(name, "is a pipe, not a file");
    fail(name, "is a device, not a file or pipe");
}

void expect_size(std::size_t size, const Rules& rules, const std::string& name) {
    if (size > rules.most_bytes) {
        fail(name, "is larger than " + std::to_string(rules.most_bytes >> 20) + " MiB");
    }
}

std::size_t read_some(const Descriptor& file, char* to, std::size_t size, const std::string& name) {
    for (;;) {
        const ssize_t got = ::read(file.number(), to, size);
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno != EINTR) fail_with_errno(name, "cannot be read");
    }
}

/// Reads to the end. `expected` is a good guess of the size; a pipe's grows as it must.
Bytes read_all(const Descriptor& file, std::size_t expected, const Rules& rules,
               const std::string& name) {
    std::size_t room = expected + 1;  // one more, to see the end without growing
    auto data = std::make_unique_for_overwrite<char[]>(room);
    std::size_t size = 0;
    while (const std::size_t got = read_some(file, data.get() + size, room - size, name)) {
        size += got;
        expect_size(size, rules, name);
        if (size < room) continue;
        room = std::min(2 * room, rules.most_bytes + 1);
        auto larger = std::make_unique_for_overwrite<char[]>(room);
        std::memcpy(larger.get(), data.get(), size);
        data = std::move(larger);
    }
    return {std::move(data), size};
}

Bytes read_open_file(const Descriptor& file, const Rules& rules, const std::string& name) {
    constexpr std::size_t first_piece = 1 << 16;
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) fail_with_errno(name, "cannot be read");
    expect_kind(status.st_mode, rules.accept, name);
    const auto size = static_cast<std::size_t>(status.st_size);
    expect_size(size, rules, name);
    return read_all(file, std::max(size, first_piece), rules, name);
}

/// Looks before it opens: opening a device can do things of its own, a pipe can wait for ever.
Bytes read_path(const std::string& path, const Rules& rules) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) fail_with_errno(path, "cannot be opened");
    expect_kind(status.st_mode, rules.accept, path);
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) fail_with_errno(path, "cannot be opened");
    return read_open_file(file, rules, path);
}

}  // namespace

std::string display_name(const std::string& path) {
    return path == "-" ? "standard input" : path;
}

Bytes read_input(const std::string& path) {
    if (path != "-") return read_path(path, {Accept::files_and_pipes});
    return read_open_file(Descriptor(STDIN_FILENO), {Accept::files_and_pipes}, display_name(path));
}

Bytes read_regular_file(const std::string& path, std::size_t most_bytes) {
    return read_path(path, {Accept::files, most_bytes});
}

}  // namespace scanlight::mesh
