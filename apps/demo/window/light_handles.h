#pragma once

#include <cstddef>
#include <vector>

#include "apps/demo/window/state.h"
#include "render/camera.h"

namespace scanlight::apps::window {

// Lights as points in a picture, to be dragged. A lamp is seen where it is. A light at infinity is
// a direction: the middle of the picture comes from the viewer, the inner circle from all sides,
// the outer one from behind; the angle is even along each radius, so that the mouse can reach all.

struct LightHandle {
    std::size_t light = 0;  // its place among `lights_in`
    Point at;               // of the canvas
    bool is_behind = false;
    glm::vec3 color{1.0f};  // linear
};

/// Those of a view whose picture stands in this box. A lamp behind the eye has none.
std::vector<LightHandle> light_handles(const SceneOptions& options, const render::Camera& camera,
                                       const Box& picture);

/// The handle is moved there. A lamp keeps its distance from the eye, along the view. Lights that
/// were not said are said from now on.
SceneOptions with_light_at(SceneOptions options, std::size_t light, Point at,
                           const render::Camera& camera, const Box& picture);

/// One light more, or without the last; one stays.
SceneOptions with_more_light(SceneOptions options, const LightOption& light);
SceneOptions with_less_light(SceneOptions options);

/// Of the inner circle, in pixels; that of the outer one is twice as much.
double light_circle(const Box& picture);

}  // namespace scanlight::apps::window
