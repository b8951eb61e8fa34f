#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/settings.h"
#include "apps/demo/stage.h"
#include "apps/scanlight/picture.h"
#include "apps/scanlight/text_table.h"
#include "mesh/build.h"
#include "mesh/shapes.h"
#include "mesh/trigonometry.h"
#include "render/draw.h"
#include "shading/vector.h"

namespace scanlight::demo {

namespace {

const std::string shape = "cylinder:14";
const std::vector<std::string> weightings{"mean", "area", "angle"};

std::string arguments(const std::string& normals, double crease_deg, const std::string& look) {
    return shape + " --view 25,30 --normals " + normals + " --crease " +
           apps::fixed(crease_deg, 0) + " " + look;
}

mesh::NormalWeight weight_named(const std::string& word) {
    if (word == "area") return mesh::NormalWeight::area;
    return word == "angle" ? mesh::NormalWeight::angle : mesh::NormalWeight::mean;
}

mesh::Mesh built(const std::string& weighting, double crease_deg) {
    return mesh::build(mesh::shape(shape),
                       {weight_named(weighting), static_cast<float>(crease_deg)})
        .mesh;
}

enum class Part { lid, side };

Part part_of(const mesh::Mesh& mesh, std::size_t face) {
    return std::abs(mesh.face_normals[face].y) > 0.5f ? Part::lid : Part::side;
}

/// By how much a corner's normal leans away from its face's, at most; in degrees.
double most_lean(const mesh::Mesh& mesh, Part part) {
    double least_cosine = 1.0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (part_of(mesh, f) != part) continue;
        for (const std::uint32_t vertex : mesh.face(f)) {
            const shading::Vec3<double> corner(mesh.vertices.normal(vertex));
            const shading::Vec3<double> face(mesh.face_normals[f]);
            least_cosine = std::min(least_cosine, shading::dot(corner, face));
        }
    }
    return std::acos(std::clamp(least_cosine, -1.0, 1.0)) * 180.0 / mesh::pi;
}

Curve lean_curve(const std::string& weighting, Part part) {
    Curve curve{weighting, {}};
    for (double crease = 0.0; crease <= 180.0; crease += 7.5)
        curve.points.emplace_back(crease, most_lean(built(weighting, crease), part));
    return curve;
}

Plot lean_plot(const std::string& key, Part part, double crease) {
    Plot plot{key, {"crease-axis", 0, 180}, {"lean-axis", 0, 90}, {}, crease};
    for (const std::string& word : weightings)
        plot.curves.push_back(lean_curve(word, part));
    return plot;
}

Panel normals_panel(const std::string& arguments, raster::Viewport size) {
    const Stage stage(arguments, size);
    const auto normals = render::draw_normals(stage.scene(), stage.options().settings, size);
    return {"normals", apps::normals_image(normals),
            stage.command(" --aov normal:normals.png -o picture.png")};
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const double crease = settings.at("crease");
    const std::string& weighting = word_of(weightings, settings, "weighting");
    const mesh::Mesh mesh = built(weighting, crease);
    Screen screen{
        {panel_of("faces", arguments(weighting, crease, "--shading flat --wireframe=over"), size,
                  means),
         panel_of("averaged", arguments(weighting, crease, "--shading phong"), size, means),
         normals_panel(arguments(weighting, crease, "--shading phong"), size)},
        {{"faces", static_cast<double>(mesh.face_count())},
         {"vertices", static_cast<double>(mesh.vertices.size())},
         {"lean-lid", most_lean(mesh, Part::lid), 1, "°"},
         {"lean-side", most_lean(mesh, Part::side), 1, "°"}}};
    screen.plots = {lean_plot("lean-lid-plot", Part::lid, crease),
                    lean_plot("lean-side-plot", Part::side, crease)};
    return screen;
}

}  // namespace

Lesson averaged_normals_lesson() {
    return {"averaged-normals",
            {{"crease", "", Slider{0, 180, 7, 60}}, {"weighting", "", Choice{weightings}}},
            {{"mesh/normals.h", "corner_normals"}, {"mesh/newell.h", "area_vector"}},
            draw};
}

}  // namespace scanlight::demo
