#include "mesh/teapot.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/add_face.h"
#include "mesh/weld.h"

namespace scanlight::mesh {
namespace {

// The original's space: z up, the spout towards +x, standing on z = 0. Of the 306 control points
// only those that mirroring and quarter turns about z do not give are listed.

using Patch = std::array<std::array<glm::dvec3, 4>, 4>;  // rows, columns

/// Control points of a quarter circle about the z axis: (radius, 0), (radius, bend),
/// (bend, radius), (0, radius) at a height.
struct Quarter {
    double radius, bend, height;
};
using Profile = std::array<Quarter, 4>;

/// Control points of half a cross-section of a tube, from the one on the plane y = 0 to the other.
struct Half {
    double x0, z0;  // at y = 0
    double width;   // y of the two points between
    double x3, z3;  // at y = 0 again
};
using Tube = std::array<Half, 4>;

// Rim, upper and lower body, bottom.
constexpr std::array<Profile, 4> body{{
    {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},
    {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2.0, 1.12, 1.35}, {2.0, 1.12, 0.9}}},
    {{{2.0, 1.12, 0.9}, {2.0, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},
    {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0.0}, {0.0, 0.0, 0.0}}},
}};

// Knob and cover.
constexpr std::array<Profile, 2> lid{{
    {{{0.0, 0.0, 3.15}, {0.8, 0.45, 3.15}, {0.0, 0.0, 2.85}, {0.2, 0.112, 2.7}}},
    {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}},
}};

// Upper and lower; each section from the inside of the bow to its outside.
constexpr std::array<Tube, 2> handle{{
    {{{-1.6, 2.025, 0.3, -1.5, 2.25},
      {-2.3, 2.025, 0.3, -2.5, 2.25},
      {-2.7, 2.025, 0.3, -3.0, 2.25},
      {-2.7, 1.8, 0.3, -3.0, 1.8}}},
    {{{-2.7, 1.8, 0.3, -3.0, 1.8},
      {-2.7, 1.575, 0.3, -3.0, 1.35},
      {-2.5, 1.125, 0.3, -2.65, 0.9375},
      {-2.0, 0.9, 0.3, -1.9, 0.6}}},
}};

// Lower and upper; each section from its upper side to its lower.
constexpr std::array<Tube, 2> spout{{
    {{{1.7, 1.425, 0.66, 1.7, 0.6},
      {2.6, 1.425, 0.66, 3.1, 0.825},
      {2.3, 2.1, 0.25, 2.4, 2.025},
      {2.7, 2.4, 0.25, 3.3, 2.4}}},
    {{{2.7, 2.4, 0.25, 3.3, 2.4},
      {2.8, 2.475, 0.25, 3.525, 2.49375},
      {2.9, 2.475, 0.15, 3.45, 2.5125},
      {2.8, 2.4, 0.15, 3.2, 2.4}}},
}};

// All patches face outward where rows run down and columns to the right.

Patch patch_of(const Profile& profile) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto& [radius, bend, height] = profile[row];
        patch[row] = {{{radius, 0, height},
                       {radius, bend, height},
                       {bend, radius, height},
                       {0, radius, height}}};
    }
    return patch;
}

Patch patch_of(const Tube& tube) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto& [x0, z0, width, x3, z3] = tube[row];
        patch[row] = {{{x0, 0, z0}, {x0, width, z0}, {x3, width, z3}, {x3, 0, z3}}};
    }
    return patch;
}

/// By a quarter turn about the z axis.
Patch turned(Patch patch) {
    for (auto& row : patch) {
        for (glm::dvec3& p : row) {
            p = {-p.y, p.x, p.z};
        }
    }
    return patch;
}

/// In the plane y = 0; the columns run backwards, so that the patch still faces outward.
Patch mirrored(const Patch& patch) {
    Patch mirror;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            const glm::dvec3& p = patch[row][3 - column];
            mirror[row][column] = {p.x, -p.y, p.z};
        }
    }
    return mirror;
}

std::vector<Patch> turned_around(std::span<const Profile> profiles) {
    std::vector<Patch> patches;
    for (const Profile& profile : profiles) {
        patches.push_back(patch_of(profile));
        for (int quarter = 1; quarter < 4; ++quarter) {
            patches.push_back(turned(patches.back()));
        }
    }
    return patches;
}

std::vector<Patch> with_mirror_images(std::span<const Tube> tubes) {
    std::vector<Patch> patches;
    for (const Tube& tube : tubes) {
        patches.push_back(patch_of(tube));
        patches.push_back(mirrored(patches.back()));
    }
    return patches;
}

/// Bernstein's polynomials at i/n, times n^3: whole numbers, so that a seam has the same bits from
/// both sides.
std::array<double, 4> bernstein(double i, double n) {
    const double j = n - i;
    return {j * j * j, 3 * i * j * j, 3 * i * i * j, i * i * i};
}

glm::dvec3 point_on(const Patch& patch, double row, double column, double n) {
    const std::array<double, 4> down = bernstein(row, n);
    const std::array<double, 4> right = bernstein(column, n);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            sum += down[i] * right[j] * patch[i][j];
        }
    }
    return sum / (n * n * n * n * n * n);
}

/// From the original's space to object space.
glm::vec3 placed(const glm::dvec3& p) {
    constexpr double half_height = 3.15 / 2;
    return 0.5 * glm::dvec3(p.x, p.z - half_height, -p.y);
}

void add_patch(PolygonSoup& soup, Welder& points, const Patch& patch, std::uint32_t n) {
    const auto before = static_cast<std::uint32_t>(soup.positions.size());
    std::vector<std::uint32_t> lattice;
    for (std::uint32_t row = 0; row <= n; ++row) {
        for (std::uint32_t column = 0; column <= n; ++column) {
            const glm::vec3 point = placed(point_on(patch, row, column, n));
            lattice.push_back(before + points.index_of(point));
        }
    }
    add_quads(soup, n, n, [&](std::uint32_t column, std::uint32_t row) {
        return PolygonSoup::Corner{.position = lattice[row * (n + 1) + column]};
    });
}

/// Patches share points within a part only: the handle ends in a point of the body by chance.
void add_part(PolygonSoup& soup, const std::vector<Patch>& patches, std::uint32_t n) {
    Welder points;
    for (const Patch& patch : patches) {
        add_patch(soup, points, patch, n);
    }
    const std::vector<glm::vec3> positions = std::move(points).take();
    soup.positions.insert(soup.positions.end(), positions.begin(), positions.end());
}

}  // namespace

PolygonSoup teapot(std::uint32_t n) {
    PolygonSoup soup;
    add_part(soup, turned_around(body), n);
    add_part(soup, turned_around(lid), n);
    add_part(soup, with_mirror_images(handle), n);
    add_part(soup, with_mirror_images(spout), n);
    return soup;
}

}  // namespace scanlight::mesh
