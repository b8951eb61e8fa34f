#include "mesh/round_shapes.h"

#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/add_face.h"
#include "mesh/circle.h"
#include "mesh/edge_pairs.h"
#include "mesh/polygons.h"
#include "mesh/trigonometry.h"

namespace scanlight::mesh {
namespace {

using Corner = PolygonSoup::Corner;

PolygonSoup icosahedron() {
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;  // the golden ratio
    PolygonSoup soup;
    for (const glm::dvec3& p : std::array<glm::dvec3, 12>{{{-1, g, 0},
                                                           {1, g, 0},
                                                           {-1, -g, 0},
                                                           {1, -g, 0},
                                                           {0, -1, g},
                                                           {0, 1, g},
                                                           {0, -1, -g},
                                                           {0, 1, -g},
                                                           {g, 0, -1},
                                                           {g, 0, 1},
                                                           {-g, 0, -1},
                                                           {-g, 0, 1}}}) {
        soup.positions.emplace_back(glm::normalize(p));
    }
    for (const auto& [a, b, c] : std::array<std::array<std::uint32_t, 3>, 20>{
             {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
              {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
              {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}}) {
        add_face(soup, {a, b, c});
    }
    return soup;
}

/// Four triangles for each. The new points lie on the unit sphere, one an edge.
PolygonSoup cut_in_four(const PolygonSoup& soup) {
    const Polygons triangles = drawable_polygons(soup);
    const std::vector<std::uint32_t> partner = pair_edges(soup, triangles).partner;
    PolygonSoup cut;
    cut.positions = soup.positions;
    std::vector<std::uint32_t> middle(triangles.corner_count());  // of a half-edge
    for (std::uint32_t c = 0; c < middle.size(); ++c) {
        if (partner[c] < c) {
            middle[c] = middle[partner[c]];
            continue;
        }
        middle[c] = static_cast<std::uint32_t>(cut.positions.size());
        const glm::dvec3 begin = soup.positions[triangles.point[c]];
        const glm::dvec3 end = soup.positions[triangles.point[triangles.next(c)]];
        cut.positions.emplace_back(glm::normalize(begin + end));
    }
    for (std::uint32_t c = 0; c < middle.size(); c += 3) {
        for (const std::uint32_t corner : {c, c + 1, c + 2}) {
            add_face(cut,
                     {triangles.point[corner], middle[corner], middle[triangles.previous(corner)]});
        }
        add_face(cut, {middle[c], middle[c + 1], middle[c + 2]});
    }
    return cut;
}

/// A ring of points around the y axis.
void add_ring(PolygonSoup& soup, const std::vector<Direction>& around, double radius, double y) {
    for (const Direction& d : around) {
        soup.positions.emplace_back(radius * d.sine, y, radius * d.cosine);
    }
}

/// The ends of a cylinder take their uv from above, x to the right.
std::uint32_t add_end_uv(PolygonSoup& soup, const Direction& d) {
    soup.uvs.emplace_back(0.5 + 0.5 * d.sine, 0.5 - 0.5 * d.cosine);
    return static_cast<std::uint32_t>(soup.uvs.size() - 1);
}

/// Of waves in a direction, 0 to 1: 8 turns of a cosine around the y axis, and 8 from pole to pole.
double wave_height(const glm::dvec3& direction) {
    const double azimuth = angle_of(direction.x, direction.z);
    const double across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    const double elevation = angle_of(direction.y, across);  // below the horizon a turn more
    return 0.5 + 0.5 * cosine(8.0 * azimuth) * cosine(16.0 * elevation);
}

}  // namespace

PolygonSoup icosphere(std::uint32_t level) {
    PolygonSoup soup = icosahedron();
    for (std::uint32_t i = 0; i < level; ++i) {
        soup = cut_in_four(soup);
    }
    return soup;
}

PolygonSoup uv_sphere(std::uint32_t slices, std::uint32_t stacks) {
    PolygonSoup soup;
    const std::vector<Direction> around = circle(slices);
    const std::uint32_t south = 1 + (stacks - 1) * slices;
    soup.positions.emplace_back(0, 1, 0);
    for (std::uint32_t stack = 1; stack < stacks; ++stack) {
        const double polar = pi * stack / stacks;
        add_ring(soup, around, sine(polar), cosine(polar));
    }
    soup.positions.emplace_back(0, -1, 0);
    for (std::uint32_t stack = 0; stack <= stacks; ++stack) {
        // The one corner a triangle has at a pole takes the middle of its slice.
        const double shift = stack == 0 ? -0.5 : stack == stacks ? 0.5 : 0.0;
        for (std::uint32_t slice = 0; slice <= slices; ++slice) {
            soup.uvs.emplace_back((slice + shift) / slices, 1.0 - double(stack) / stacks);
        }
    }
    add_quads(soup, slices, stacks, [&](std::uint32_t slice, std::uint32_t stack) {
        const std::uint32_t position = stack == 0 ? 0
                                       : stack == stacks
                                           ? south
                                           : 1 + (stack - 1) * slices + slice % slices;
        return Corner{.position = position, .uv = stack * (slices + 1) + slice};
    });
    return soup;
}

PolygonSoup wavy_sphere(std::uint32_t slices, std::uint32_t stacks) {
    PolygonSoup soup = uv_sphere(slices, stacks);
    for (glm::vec3& p : soup.positions)
        p *= static_cast<float>(1.0 + 0.03 * wave_height(glm::dvec3(p)));
    return soup;
}

PolygonSoup torus(std::uint32_t segments, std::uint32_t sides) {
    constexpr double ring_radius = 0.7;
    constexpr double tube_radius = 0.3;
    PolygonSoup soup;
    const std::vector<Direction> around = circle(segments);
    for (const Direction& d : circle(sides)) {  // from the inside over the top
        add_ring(soup, around, ring_radius - tube_radius * d.cosine, tube_radius * d.sine);
    }
    for (std::uint32_t side = 0; side <= sides; ++side) {
        for (std::uint32_t segment = 0; segment <= segments; ++segment) {
            soup.uvs.emplace_back(double(segment) / segments, 1.0 - double(side) / sides);
        }
    }
    add_quads(soup, segments, sides, [&](std::uint32_t segment, std::uint32_t side) {
        return Corner{.position = side % sides * segments + segment % segments,
                      .uv = side * (segments + 1) + segment};
    });
    return soup;
}

PolygonSoup cylinder(std::uint32_t segments) {
    PolygonSoup soup;
    const std::vector<Direction> around = circle(segments);
    add_ring(soup, around, 1.0, 1.0);
    add_ring(soup, around, 1.0, -1.0);
    for (const double v : {1.0, 0.0}) {
        for (std::uint32_t segment = 0; segment <= segments; ++segment) {
            soup.uvs.emplace_back(double(segment) / segments, v);
        }
    }
    add_quads(soup, segments, 1, [&](std::uint32_t segment, std::uint32_t row) {
        return Corner{.position = row * segments + segment % segments,
                      .uv = row * (segments + 1) + segment};
    });
    std::vector<Corner> top;
    std::vector<Corner> bottom(segments);
    for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t uv = add_end_uv(soup, around[i]);
        top.push_back({.position = i, .uv = uv});
        bottom[segments - 1 - i] = {.position = segments + i, .uv = uv};
    }
    add_face(soup, top);
    add_face(soup, bottom);
    return soup;
}

PolygonSoup cone(std::uint32_t segments) {
    PolygonSoup soup;
    add_ring(soup, circle(segments), 1.0, -1.0);
    soup.positions.emplace_back(0, 1, 0);
    std::vector<Corner> base(segments);
    for (std::uint32_t i = 0; i < segments; ++i) {
        add_face(soup, {segments, i, (i + 1) % segments});
        base[segments - 1 - i] = {.position = i};
    }
    add_face(soup, base);
    return soup;
}

}  // namespace scanlight::mesh
