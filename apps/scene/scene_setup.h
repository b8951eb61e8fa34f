#pragma once

#include "apps/scene/models.h"
#include "apps/scene/scene_options.h"
#include "render/scene.h"

namespace scanlight::apps {

/// The scene that the options describe, of their models, which must outlive it.
render::Scene scene_of(const Models& models, const SceneOptions& options);

/// The same without a camera, and without what hangs on it: to be `seen` again and again.
render::Scene unseen_scene_of(const Models& models, const SceneOptions& options);

/// An unseen scene of these models, by the camera of these options.
render::Scene seen(render::Scene unseen, const Models& models, const SceneOptions& options);

/// The camera's angle of view, projection and up vector, without its place.
render::Camera bare_camera(const SceneOptions& options);

}  // namespace scanlight::apps
