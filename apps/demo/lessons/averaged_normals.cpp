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

/// By how much a corner's normal leans away from its face's, at most; in degrees.
double most_lean(const mesh::Mesh& mesh) {
    double least_cosine = 1.0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        for (const std::uint32_t vertex : mesh.face(f)) {
            const shading::Vec3<double> corner(mesh.vertices.normal(vertex));
            const shading::Vec3<double> face(mesh.face_normals[f]);
            least_cosine = std::min(least_cosine, shading::dot(corner, face));
        }
    }
    return std::acos(std::clamp(least_cosine, -1.0, 1.0)) * 180.0 / mesh::pi;
}

Curve lean_curve(const std::string& weighting) {
    Curve curve{weighting, {}};
    for (double crease = 0.0; crease <= 180.0; crease += 7.5)
        curve.points.emplace_back(crease, most_lean(built(weighting, crease)));
    return curve;
}

Panel normals_panel(const std::string& arguments, raster::Viewport size) {
    const Stage stage(arguments, size);
    const auto normals = render::draw_normals(stage.scene(), stage.options().settings, size);
    return {"normals", apps::normals_image(normals),
            stage.command(" --aov normal:normals.png -o picture.png")};
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const double crease = settings.at("crease");
    const std::string& weighting = weightings[static_cast<std::size_t>(settings.at("weighting"))];
    const mesh::Mesh mesh = built(weighting, crease);
    Screen screen{
        {panel_of("faces", arguments(weighting, crease, "--shading flat --wireframe=over"), size,
                  means),
         panel_of("averaged", arguments(weighting, crease, "--shading phong"), size, means),
         normals_panel(arguments(weighting, crease, "--shading phong"), size)},
        {{"faces", static_cast<double>(mesh.face_count())},
         {"vertices", static_cast<double>(mesh.vertices.size())},
         {"lean", most_lean(mesh), 1, "°"}}};
    screen.plots = {{"lean-plot", {"crease-axis", 0, 180}, {"lean-axis", 0, 90}, {}, crease}};
    for (const std::string& word : weightings)
        screen.plots.front().curves.push_back(lean_curve(word));
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
