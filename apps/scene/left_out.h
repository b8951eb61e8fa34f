#pragma once

#include <string>
#include <vector>

#include "apps/scene/scene_options.h"
#include "render/scene.h"

namespace scanlight::apps {

/// For a person: what surfaces of the scene have that its picture will not show, a sentence each.
std::vector<std::string> left_out(const render::Scene& scene, const SceneOptions& options);

}  // namespace scanlight::apps
