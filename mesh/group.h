#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scanlight::mesh {

/// Items 0, 1, 2 … sorted into groups by a counting sort; within a group they ascend.
struct Groups {
    std::vector<std::uint32_t> items;
    std::vector<std::uint32_t> begin;  // groups + 1 of them

    std::size_t size() const { return begin.size() - 1; }
    std::span<std::uint32_t> operator[](std::size_t g) {
        return std::span(items).subspan(begin[g], begin[g + 1] - begin[g]);
    }
};

/// Item i goes to group key[i], which is below `groups`.
Groups group_by(std::span<const std::uint32_t> key, std::size_t groups);

}  // namespace scanlight::mesh
