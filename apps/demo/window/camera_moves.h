#pragma once

#include "apps/demo/window/state.h"
#include "render/camera.h"

namespace scanlight::apps::window {

// How the mouse moves a camera. `camera` is that by which the picture was drawn when the drag
// began, `by` how far the mouse is from there, in pixels of a picture of that height. What comes
// out is rounded, so that scene files and command lines are short.

/// About its target, as if the thing were turned by the hand; never over the poles.
SceneOptions turned(SceneOptions options, const render::Camera& camera, Point by);

/// Beside its view: what is at the target's distance stays under the mouse.
SceneOptions panned(SceneOptions options, const render::Camera& camera, Point by, int height);

/// Enlarged by a tenth for each notch of the wheel.
SceneOptions zoomed(SceneOptions options, double notches);

/// The side from which a direction comes, which is that from the target towards the eye.
render::ViewAngles angles_of(const glm::dvec3& direction);

}  // namespace scanlight::apps::window
