#include "mesh/weld.h"

#include <algorithm>
#include <bit>

namespace scanlight::mesh {
namespace {

constexpr std::uint32_t vacant = 0xffffffffu;

/// Finite points only; adding zero turns -0 into 0.
glm::vec3 without_minus_zero(const glm::vec3& point) {
    return point + 0.0f;
}

/// Multiplies and folds, as in Steele, Lea & Flood 2014, "Fast splittable pseudorandom number
/// generators" (OOPSLA): every bit of the point reaches every bit of the hash.
std::uint64_t hash(const glm::vec3& point) {
    std::uint64_t h = 0;
    for (const float value : {point.x, point.y, point.z}) {
        h = (h ^ std::bit_cast<std::uint32_t>(value)) * 0xbf58476d1ce4e5b9u;
        h ^= h >> 31;
    }
    h *= 0x94d049bb133111ebu;
    return h ^ (h >> 29);
}

}  // namespace

Welder::Welder(std::size_t points) {
    rehash(std::bit_ceil(std::max<std::size_t>(points, 16)));
}

std::size_t Welder::slot_of(const glm::vec3& point) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash(point)) & mask;
    while (slots_[slot] != vacant && positions_[slots_[slot]] != point)
        slot = (slot + 1) & mask;
    return slot;
}

void Welder::rehash(std::size_t slots) {
    slots_.assign(slots, vacant);
    for (std::uint32_t i = 0; i < positions_.size(); ++i)
        slots_[slot_of(positions_[i])] = i;
}

std::uint32_t Welder::index_of(const glm::vec3& raw) {
    const glm::vec3 point = without_minus_zero(raw);
    const std::size_t slot = slot_of(point);
    if (slots_[slot] != vacant) return slots_[slot];
    const auto index = static_cast<std::uint32_t>(positions_.size());
    slots_[slot] = index;
    positions_.push_back(point);
    if (2 * positions_.size() > slots_.size()) rehash(2 * slots_.size());
    return index;
}

}  // namespace scanlight::mesh
