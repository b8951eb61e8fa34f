#include "mesh/add_face.h"

#include <array>
#include <vector>

namespace scanlight::mesh {

void add_face(PolygonSoup& soup, std::span<const PolygonSoup::Corner> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PolygonSoup::Corner& before = corners[i == 0 ? corners.size() - 1 : i - 1];
        if (corners[i].position != before.position) soup.corners.push_back(corners[i]);
    }
    soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}

void add_face(PolygonSoup& soup, std::initializer_list<std::uint32_t> points) {
    std::vector<PolygonSoup::Corner> corners;
    for (const std::uint32_t point : points) {
        corners.push_back({.position = point});
    }
    add_face(soup, corners);
}

void add_quads(PolygonSoup& soup, std::uint32_t columns, std::uint32_t rows,
               const std::function<PolygonSoup::Corner(std::uint32_t, std::uint32_t)>& corner_at) {
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            add_face(soup, std::array{corner_at(column, row), corner_at(column, row + 1),
                                      corner_at(column + 1, row + 1), corner_at(column + 1, row)});
        }
    }
}

}  // namespace scanlight::mesh
