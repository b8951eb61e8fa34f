#pragma once

#include "apps/scanlight/model.h"
#include "apps/scanlight/scene_options.h"
#include "render/scene.h"

namespace scanlight::apps {

/// The model of the options' input, cut into triangles when they ask for it.
Model load_model(const SceneOptions& options);

/// The scene that the options describe. The model must outlive it.
render::Scene scene_of(const Model& model, const SceneOptions& options);

}  // namespace scanlight::apps
