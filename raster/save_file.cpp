#include "raster/save_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "raster/file_descriptor.h"
#include "raster/image_error.h"

namespace scanlight::raster {

namespace {

namespace fs = std::filesystem;
using Contents = std::span<const std::uint8_t>;

[[noreturn]] void fail(const std::string& path, int error) {
    throw ImageError(path + ": cannot be written: " + std::generic_category().message(error));
}

// While it lives, writing into a closed pipe is an error of this thread and not a signal.
class SigpipeHeld {
public:
    SigpipeHeld() {
        sigemptyset(&sigpipe_);
        sigaddset(&sigpipe_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        was_pending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &sigpipe_, &old_mask_);
    }
    ~SigpipeHeld() {
        const timespec at_once{};
        if (!was_pending_)
            uninterrupted([&] { return sigtimedwait(&sigpipe_, nullptr, &at_once); });
        pthread_sigmask(SIG_SETMASK, &old_mask_, nullptr);
    }
    SigpipeHeld(const SigpipeHeld&) = delete;
    SigpipeHeld& operator=(const SigpipeHeld&) = delete;

private:
    sigset_t sigpipe_;
    sigset_t old_mask_;
    bool was_pending_;
};

// A write may take fewer bytes than it is given.
void write_all(int fd, Contents bytes, const std::string& path) {
    const SigpipeHeld held;
    while (!bytes.empty()) {
        const auto written = uninterrupted([&] { return ::write(fd, bytes.data(), bytes.size()); });
        if (written <= 0) fail(path, written == 0 ? EIO : errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

// What the program printed before comes first.
void write_to_standard_output(Contents bytes) {
    const std::string name = "standard output";
    const SigpipeHeld held;
    if (std::fflush(stdout) != 0) fail(name, errno);
    write_all(STDOUT_FILENO, bytes, name);
}

void write_in_place(const std::string& path, Contents bytes) {
    FileDescriptor file(
        uninterrupted([&] { return ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC); }));
    if (!file.is_open()) fail(path, errno);
    write_all(file.get(), bytes, path);
    if (!file.close()) fail(path, errno);
}

// The path that the last of a chain of links names; it need not exist.
fs::path follow_links(const std::string& path) {
    fs::path target = path;
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
        if (links == 40) fail(path, ELOOP);
        target = target.parent_path() / fs::read_symlink(target, error);
        if (error) fail(path, error.value());
    }
    return target;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// A new file beside the target. Invariant: it exists until it takes the target's name, or the
// object goes.
class TemporaryFile {
public:
    TemporaryFile(const fs::path& folder, const std::string& path) : file_(create(folder)) {
        if (!file_.is_open()) fail(path, errno);
    }
    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    FileDescriptor& file() { return file_; }

    bool take_name(const fs::path& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0) return false;
        path_.clear();
        return true;
    }

private:
    // Another thread or a killed process may have taken a name.
    FileDescriptor create(const fs::path& folder) {
        const std::string stem = ".scanlight-" + std::to_string(::getpid()) + "-";
        for (int number = 0;; ++number) {
            path_ = folder / (stem + std::to_string(number));
            const int fd = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (fd >= 0 || (errno != EEXIST && errno != EINTR)) return FileDescriptor(fd);
        }
    }

    fs::path path_;
    FileDescriptor file_;
};

// rename asks nobody whether the old file may be written, and would change its mode.
bool inherit_permissions(const FileDescriptor& file, const fs::path& old) {
    struct stat status;
    if (::stat(old.c_str(), &status) != 0) return errno == ENOENT;
    return ::faccessat(AT_FDCWD, old.c_str(), W_OK, AT_EACCESS) == 0 &&
           ::fchmod(file.get(), status.st_mode & 0777) == 0;
}

bool sync(const FileDescriptor& file) {
    return uninterrupted([&] { return ::fsync(file.get()); }) == 0;
}

// Makes the new name last. Some file systems have no way to; some folders may not be opened.
bool sync_folder(const fs::path& folder) {
    const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    return !opened.is_open() || sync(opened) || errno == EINVAL;
}

void replace(const std::string& path, Contents bytes) {
    const fs::path target = follow_links(path);
    TemporaryFile temporary(folder_of(target), path);
    if (!inherit_permissions(temporary.file(), target)) fail(path, errno);
    write_all(temporary.file().get(), bytes, path);
    const bool replaced = sync(temporary.file()) && temporary.file().close() &&
                          temporary.take_name(target) && sync_folder(folder_of(target));
    if (!replaced) fail(path, errno);
}

}  // namespace

void save_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    if (path == "-") return write_to_standard_output(bytes);
    std::error_code error;
    switch (fs::status(path, error).type()) {
        case fs::file_type::regular:
        case fs::file_type::not_found:
            return replace(path, bytes);
        case fs::file_type::directory:
            fail(path, EISDIR);
        case fs::file_type::none:
            fail(path, error.value());
        default:
            return write_in_place(path, bytes);
    }
}

void save_file(const std::string& path, std::string_view text) {
    save_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace scanlight::raster
