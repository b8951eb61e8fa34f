#include "render/room.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "shading/angle.h"
#include "shading/pattern.h"

namespace scanlight::render {

namespace {

/// Where a line of sight from the middle of a cube, -1 to 1, ends: on which wall, and where on it.
struct Spot {
    int axis;          // that the wall is across
    bool far_side;     // at +1
    glm::dvec2 place;  // along the axes after it, in turn
};

Spot spot_seen(const glm::dvec3& d) {
    const glm::dvec3 size(std::abs(d.x), std::abs(d.y), std::abs(d.z));
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return {axis, d[axis] > 0.0, {d[(axis + 1) % 3] / size[axis], d[(axis + 2) % 3] / size[axis]}};
}

bool is_within(const glm::dvec2& p, const glm::dvec2& low, const glm::dvec2& high) {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
}

glm::dvec3 floor_color(const glm::dvec2& p) {
    const double light = shading::checkerboard(0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y);
    return glm::dvec3(0.08, 0.06, 0.05) + light * glm::dvec3(0.5, 0.45, 0.4);
}

glm::dvec3 ceiling_color(const glm::dvec2& p) {
    return is_within(p, glm::dvec2(-0.3), glm::dvec2(0.3)) ? glm::dvec3(3.0, 2.8, 2.4)
                                                           : glm::dvec3(0.6);
}

/// z is up. Walls across x: `place` is (y, z); across y: (z, x).
glm::dvec3 wall_color(const Spot& spot) {
    if (spot.axis == 0 && spot.far_side) {
        const bool is_bar = std::abs(spot.place.x) < 0.03 || std::abs(spot.place.y - 0.2) < 0.03;
        const bool is_window = is_within(spot.place, {-0.6, -0.3}, {0.6, 0.7}) && !is_bar;
        return is_window ? glm::dvec3(1.6, 2.0, 2.6) : glm::dvec3(0.35, 0.32, 0.3);
    }
    if (spot.axis == 0) return {0.45, 0.12, 0.08};
    return spot.far_side ? glm::dvec3(0.12, 0.3, 0.12) : glm::dvec3(0.12, 0.18, 0.42);
}

glm::dvec3 color_seen(const glm::dvec3& direction) {
    const Spot spot = spot_seen(direction);
    if (spot.axis != 2) return wall_color(spot);
    return spot.far_side ? ceiling_color(spot.place) : floor_color(spot.place);
}

}  // namespace

std::shared_ptr<const shading::TexelImage> room(int height) {
    const int width = 2 * height;
    std::vector<float> rgba;
    for (int j = 0; j < height; ++j) {
        const double v = 0.5 * (j + 0.5) / height;  // in turns from straight down
        for (int i = 0; i < width; ++i) {
            const double u = (i + 0.5) / width;
            const double sine = shading::sine_of_turns(v);
            const glm::dvec3 color =
                color_seen({sine * shading::cosine_of_turns(u), sine * shading::sine_of_turns(u),
                            -shading::cosine_of_turns(v)});
            for (int c = 0; c < 3; ++c)
                rgba.push_back(static_cast<float>(color[c]));
            rgba.push_back(1.0f);
        }
    }
    return std::make_shared<const shading::TexelImage>(width, height, rgba);
}

}  // namespace scanlight::render
