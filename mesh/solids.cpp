#include "mesh/solids.h"

#include "mesh/add_face.h"

namespace scanlight::mesh {

PolygonSoup cube() {
    PolygonSoup soup;
    for (int i = 0; i < 8; ++i) {  // bit 0 is x, bit 1 is y, bit 2 is z
        soup.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    add_face(soup, {1, 3, 7, 5});  // +x
    add_face(soup, {0, 4, 6, 2});
    add_face(soup, {2, 6, 7, 3});  // +y
    add_face(soup, {0, 1, 5, 4});
    add_face(soup, {4, 5, 7, 6});  // +z
    add_face(soup, {0, 2, 3, 1});
    return soup;
}

PolygonSoup tetrahedron() {
    PolygonSoup soup;
    soup.positions = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}};
    add_face(soup, {0, 1, 3});
    add_face(soup, {0, 2, 1});
    add_face(soup, {0, 3, 2});
    add_face(soup, {1, 2, 3});
    return soup;
}

PolygonSoup octahedron() {
    PolygonSoup soup;
    soup.positions = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}};
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t left = 1 + i;
        const std::uint32_t right = 1 + (i + 1) % 4;
        add_face(soup, {0, left, right});
        add_face(soup, {5, right, left});
    }
    return soup;
}

}  // namespace scanlight::mesh
