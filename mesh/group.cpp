#include "mesh/group.h"

#include <numeric>

namespace scanlight::mesh {

Groups group_by(std::span<const std::uint32_t> key, std::size_t groups) {
    Groups grouped{std::vector<std::uint32_t>(key.size()), std::vector<std::uint32_t>(groups + 1)};
    std::vector<std::uint32_t>& begin = grouped.begin;
    for (const std::uint32_t k : key) {
        ++begin[k];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());  // the ends, for now
    for (std::size_t i = key.size(); i-- > 0;) {
        grouped.items[--begin[key[i]]] = static_cast<std::uint32_t>(i);
    }
    return grouped;
}

}  // namespace scanlight::mesh
