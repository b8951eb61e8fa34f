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

/// A polygon that can be traced.
struct SeenPolygon {
    std::size_t face = 0;  // of the object's mesh
    std::uint32_t id = 0;  // its place in the file plus 1
    int scanlines = 0;     // how many it crosses
};

/// The polygons of the scene's first object of which something is in the picture, by face.
std::vector<SeenPolygon> seen_polygons(const Scene& scene, const Settings& settings,
                                       raster::Viewport viewport);

/// Runs the rasterizer itself, with an observer, over polygons that are seen. Interpolation is
/// bilinear for triangles too, so that edges carry their values; shading flat, gouraud or phong
/// says which values those are.
std::vector<PolygonSteps> trace_polygons(const Scene& scene, const Settings& settings,
                                         raster::Viewport viewport,
                                         const std::vector<SeenPolygon>& polygons);

/// The same over all of them.
std::vector<PolygonSteps> trace_polygons(const Scene& scene, const Settings& settings,
                                         raster::Viewport viewport);

}  // namespace scanlight::render
