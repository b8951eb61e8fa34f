#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace scanlight::mesh {

/// Gives equal points one index, by first appearance. Points are equal when their bits are, and
/// -0 is 0: no tolerance, so nothing near is ever torn or merged by chance.
class Welder {
public:
    /// `points` is how many will come, if known.
    explicit Welder(std::size_t points = 0);

    std::uint32_t index_of(const glm::vec3& point);

    /// The distinct points.
    std::vector<glm::vec3> take() && { return std::move(positions_); }

private:
    std::size_t slot_of(const glm::vec3& point) const;
    void rehash(std::size_t slots);

    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> slots_;  // open addressing; a power of 2, at most half full
};

}  // namespace scanlight::mesh
