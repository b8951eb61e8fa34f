#pragma once

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace scanlight::raster {

/// An open file. Invariant: get() is open, or -1 and nothing is.
class FileDescriptor {
public:
    explicit FileDescriptor(int fd) : fd_(fd) {}
    FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&&) = delete;
    ~FileDescriptor() {
        if (fd_ >= 0) ::close(fd_);
    }

    bool is_open() const noexcept { return fd_ >= 0; }
    int get() const noexcept { return fd_; }

    /// Closes; false, with errno, when that failed: some file systems write only then.
    bool close() noexcept { return ::close(std::exchange(fd_, -1)) == 0 || errno == EINTR; }

private:
    int fd_;
};

/// A system call made again for as long as a signal interrupts it; its result.
template <class Call>
auto uninterrupted(const Call& call) {
    auto result = call();
    while (result == -1 && errno == EINTR)
        result = call();
    return result;
}

}  // namespace scanlight::raster
