#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "raster/fixed.h"
#include "raster/project.h"
#include "render/scene.h"
#include "render/viewing.h"

namespace scanlight::render {

/// What all polygons of one picture share.
struct Frame {
    raster::Viewport viewport;
    glm::dmat4 clip_from_world;
    glm::mat4 world_from_screen;  // (x, y in pixels, depth 0 to 1, 1), then divide by w
    glm::vec4 viewpoint;          // world, homogeneous: the eye, or the direction to it
    SightLines sight_lines;       // world
    shading::Lighting<float> lighting;
    const shading::Environment* mirrored;  // see `Scene`
    const shading::Environment* diffuse;
    const shading::Environment* surroundings;

    /// Whether all lines of sight are parallel, as those of an orthographic camera.
    bool is_parallel() const {
        return clip_from_world[0][3] == 0.0 && clip_from_world[1][3] == 0.0 &&
               clip_from_world[2][3] == 0.0;
    }

    /// V: unit, from a point in world space towards the eye.
    glm::vec3 view_from(const glm::vec3& point) const {
        return render::view_from(viewpoint, point);
    }

    /// V of what a pixel's centre shows, from the line of sight.
    glm::vec3 view_at(int x, int y) const {
        return view_along(sight_row(y), static_cast<float>(x) + 0.5f);
    }
    /// Through the centres of a row of pixels.
    SightRow sight_row(int y) const;

    /// The point of the surface that a pixel's centre shows, in world space, from its depth. Depth
    /// is exact over the screen, so no position has to be interpolated.
    glm::vec3 point_at(int x, int y, raster::Depth depth) const {
        return point_behind(world_from_screen, screen_at(x, y, depth));
    }

    /// A pixel's centre, at a depth from 0 to 1.
    static glm::vec3 screen_at(int x, int y, raster::Depth depth) {
        return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f,
                raster::ndc_from_depth(depth)};
    }
};

/// The size of a picture with as many pixels as `viewport` has samples.
inline raster::Viewport size_in_samples(raster::Viewport viewport, int grid) {
    return {viewport.width * grid, viewport.height * grid};
}

/// Applies the settings' distances: with eye and lights at infinity each has one direction, that
/// from the camera's target.
Frame frame_of(const Scene& scene, Distances distances, raster::Viewport viewport);

}  // namespace scanlight::render
