#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/framebuffer.h"
#include "render/frame.h"
#include "render/light_view.h"

namespace scanlight::render {

/// The depths of what a light sees: Williams 1978, "Casting curved shadows on curved surfaces",
/// SIGGRAPH. A point is lit unless something nearer to the light is in its cell of the map.
///
/// A cell has one depth, that of its centre, for all of the surface that it shows: a surface would
/// shadow itself. So each polygon is drawn farther from the light, by as much as its own depth
/// changes over `bias` cells across and down, and each point asks from `bias` cell widths nearer to
/// the light. On a plane half a cell is enough; a shadow is moved by about as many cells.
class ShadowMap {
public:
    /// Nothing is drawn yet. `light` is homogeneous.
    ShadowMap(const std::vector<Object>& objects, const glm::dvec4& light,
              const ShadowMapRule& rule);

    /// One for a directional light, six for a point light.
    std::size_t view_count() const { return views_.size(); }

    /// Draws what one view sees. Views may be drawn by several threads, each by one.
    void draw(std::size_t view, const std::vector<Object>& objects);

    /// The share of the light that reaches a surface at a point in world space: 0 or 1, or with a
    /// filter of n x n cells a multiple of 1/n^2: in how many of them the point is lit. Reeves,
    /// Salesin & Cook 1987, "Rendering antialiased shadows with depth maps", SIGGRAPH; their
    /// samples are jittered, these are all cells.
    float share(const glm::vec3& point) const;

    std::size_t bytes() const;

private:
    struct View {
        LightView view;
        raster::Plane<raster::Depth> depth;  // of no size, where nothing is seen
    };

    float share(const View& view, const glm::dvec3& point) const;
    int lit_cells(const raster::Plane<raster::Depth>& stored, int column, int row,
                  double depth) const;

    glm::dvec4 light_;
    ShadowMapRule rule_;
    double reach_;  // in cells: the bias, and how far the filter goes
    std::vector<View> views_;
};

/// With all views drawn.
ShadowMap drawn_shadow_map(const std::vector<Object>& objects, const glm::dvec4& light,
                           const ShadowMapRule& rule);

/// The most memory that the maps of some lights take.
std::size_t most_bytes(const std::vector<shading::Light<float>>& lights, const ShadowMapRule& rule);

}  // namespace scanlight::render
