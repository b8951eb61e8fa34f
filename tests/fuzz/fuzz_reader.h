#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "mesh/file_error.h"
#include "mesh/polygon_soup.h"
#include "tests/mesh/soup_invariants.h"

namespace scanlight::mesh {

inline std::string_view as_text(const std::uint8_t* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

inline void expect(bool right, std::string_view promise) {
    if (right) return;
    std::cerr << "broken: " << promise << "\n";
    std::abort();
}

/// Any bytes are a soup that keeps its promises, or a FileError.
template <class Read>
int fuzz_reader(const std::uint8_t* bytes, std::size_t size, Read&& read) {
    try {
        const PolygonSoup soup = read(as_text(bytes, size));
        const std::string broken = broken_promise(soup);
        expect(broken.empty(), broken);
        expect(bytes_of(soup) <= memory_bound(size), "the memory bound");
        expect(soup.warnings.size() < 256, "few warnings");
    } catch (const FileError& error) {
        expect(std::string_view(error.what()).starts_with("fuzz"), "a message names its file");
    }
    return 0;
}

}  // namespace scanlight::mesh
