#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "raster/framebuffer.h"
#include "raster/trace.h"
#include "render/scene.h"

namespace scanlight::render {

/// What the scanline algorithm does to one polygon of a scene, in numbers for people to read.
/// `names` are those of the values interpolated: I_r I_g I_b for intensities, N_x N_y N_z for
/// normals, none for flat shading; in correct perspective the values are multiplied by q, and so
/// are the names: "I_r q".
struct PolygonSteps {
    struct Corner {
        double x, y;  // pixels
        double z;     // depth, 0 to 1
        std::vector<double> values;
    };
    std::size_t face = 0;  // of the object's mesh
    std::uint32_t id = 0;  // its place in the file plus 1
    std::vector<std::string> names;
    std::vector<Corner> corners;
    raster::Trace trace;  // edge i runs from corner i to the next
};

/// Runs the rasterizer itself, with an observer, over each polygon that is seen of the scene's
/// first object. Interpolation is bilinear for triangles too, so that edges carry their values;
/// shading flat, gouraud or phong says which values those are.
std::vector<PolygonSteps> trace_polygons(const Scene& scene, const Settings& settings,
                                         raster::Viewport viewport);

}  // namespace scanlight::render
