#pragma once

#include <cstddef>
#include <vector>

namespace scanlight::raster {

/// No vector holds more numbers. Streams are so much longer than what is in them, for lanes read
/// and write whole vectors.
inline constexpr std::size_t most_lanes = 64;

/// The memory that vectors hold, in bytes, used or not.
template <class... T>
std::size_t bytes_held(const std::vector<T>&... vectors) {
    return ((vectors.capacity() * sizeof(T)) + ... + 0);
}

}  // namespace scanlight::raster
