#include "mesh/circle.h"

#include "mesh/trigonometry.h"

namespace scanlight::mesh {

std::vector<Direction> circle(std::uint32_t count) {
    std::vector<Direction> directions;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * i / count;
        directions.push_back({sine(angle), cosine(angle)});
    }
    return directions;
}

}  // namespace scanlight::mesh
