#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace scanlight::raster {

/// No vector holds more numbers. Streams are so much longer than what is in them, for lanes read
/// and write whole vectors.
inline constexpr std::size_t most_lanes = 64;

/// For memory that begins with a line of the cache: to read or write vectors across two lines
/// takes twice the time.
template <class T>
struct LineAllocator {
    using value_type = T;
    static constexpr std::size_t line = 64;  // bytes

    LineAllocator() = default;
    template <class U>
    LineAllocator(const LineAllocator<U>&) noexcept {}

    T* allocate(std::size_t n) {
        return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{line}));
    }
    void deallocate(T* memory, std::size_t) { ::operator delete (memory, std::align_val_t{line}); }
    template <class U>
    bool operator==(const LineAllocator<U>&) const {
        return true;
    }
};

template <class T>
using LineVector = std::vector<T, LineAllocator<T>>;

/// The memory that vectors hold, in bytes, used or not.
template <class... Vectors>
std::size_t bytes_held(const Vectors&... vectors) {
    return ((vectors.capacity() * sizeof(typename Vectors::value_type)) + ... + 0);
}

}  // namespace scanlight::raster
