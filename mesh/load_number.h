#pragma once

#include <bit>
#include <cstddef>

namespace scanlight::mesh {

/// The number whose bytes lie at `from`, in the byte order `order`; aligned or not.
template <class Number, std::endian order>
inline Number load_number(const char* from) {
    struct Raw {
        char bytes[sizeof(Number)];
    } raw;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
        raw.bytes[i] = from[order == std::endian::native ? i : sizeof(Number) - 1 - i];
    }
    return std::bit_cast<Number>(raw);
}

}  // namespace scanlight::mesh
