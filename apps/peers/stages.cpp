#include "apps/peers/stages.h"

#include <cstdint>
#include <filesystem>

#include "apps/peers/surfaces.h"
#include "mesh/build.h"
#include "mesh/load.h"
#include "mesh/round_shapes.h"
#include "mesh/teapot.h"
#include "mesh/triangulate.h"

namespace scanlight::peers {

namespace {

using Order = LayerOrder;
using MakeMesh = std::function<mesh::Mesh(double aspect)>;

mesh::Mesh triangles_of(const mesh::PolygonSoup& soup) {
    return mesh::triangulated(mesh::build(soup).mesh);
}

MakeMesh sphere(std::uint32_t rings) {
    return [rings](double) { return triangles_of(displaced_sphere(rings)); };
}

mesh::Mesh sheet(double aspect) {
    return mesh::build(wavy_sheet(1000, 500, aspect)).mesh;
}

MakeMesh layers(Order order) {
    return [order](double aspect) {
        const auto soup = full_screen_layers(8, order, aspect, window_distance());
        return mesh::build(soup, {mesh::NormalWeight::file}).mesh;
    };
}

MakeMesh cut(MakeMesh make) {
    return [make](double aspect) { return mesh::triangulated(make(aspect)); };
}

}  // namespace

std::vector<StagePlan> usual_stages() {
    return {
        {"ball", View::filled, [](double) { return triangles_of(mesh::uv_sphere(64, 33)); }},
        {"teapot", View::framed, [](double) { return triangles_of(mesh::teapot(10)); }},
        {"sphere-100k", View::framed, sphere(158)},
        {"sphere-400k", View::framed, sphere(316)},
        {"sphere-1M", View::framed, sphere(500)},
        {"sheet-1M", View::window, cut(sheet)},
        {"layers-back-to-front", View::window, cut(layers(Order::back_to_front))},
        {"layers-front-to-back", View::window, cut(layers(Order::front_to_back))},
        {"quads-sheet-500k", View::window, sheet},
        {"quads-back-to-front", View::window, layers(Order::back_to_front)},
        {"quads-front-to-back", View::window, layers(Order::front_to_back)},
    };
}

StagePlan stage_from_file(const std::string& path) {
    return {std::filesystem::path(path).stem().string(), View::framed,
            [path](double) { return triangles_of(mesh::load(path)); }};
}

}  // namespace scanlight::peers
