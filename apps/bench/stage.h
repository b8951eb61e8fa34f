#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "render/frame.h"
#include "render/placed_mesh.h"
#include "render/scene.h"
#include "render/screen_polygons.h"

namespace scanlight::bench {

/// A built-in shape, cut into triangles, in front of a camera and one light, in a 1920 x 1080
/// picture.
class Stage {
public:
    explicit Stage(const std::string& shape);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    const std::string& name() const { return name_; }
    std::size_t triangle_count() const { return mesh_.face_count(); }
    raster::Viewport viewport() const { return frame_.viewport; }
    int pixels() const { return frame_.viewport.width * frame_.viewport.height; }
    const render::Scene& scene() const { return scene_; }
    const render::Frame& frame() const { return frame_; }
    const render::PlacedMesh& placed() const { return placed_; }

private:
    std::string name_;
    mesh::Mesh mesh_;
    render::Scene scene_;
    render::Frame frame_;
    render::PlacedMesh placed_;
};

/// A triangle on the screen, and which one of the mesh it is.
template <int N>
struct SeenTriangle {
    std::size_t face;
    render::ScreenPolygon<N> polygon;
};

/// The triangles that are not culled, up to where interpolation begins.
template <class Technique>
std::vector<SeenTriangle<Technique::attribute_count>> seen_triangles(
    const Stage& stage, const Technique& technique, const render::Settings& settings) {
    const render::ScreenPolygons<Technique> polygons(stage.placed(), technique, stage.frame(),
                                                     settings);
    std::vector<SeenTriangle<Technique::attribute_count>> seen;
    for (std::size_t face = 0; face < stage.triangle_count(); ++face) {
        const auto polygon = polygons[face];
        if (polygon.fate == render::Fate::seen) seen.push_back({face, polygon});
    }
    return seen;
}

}  // namespace scanlight::bench
