#pragma once

#include <string>

#include "apps/scene/scene_options.h"

namespace scanlight::apps {

/// The TOML of a scene file that shows the same picture, to the bit. `folder` is where it will lie,
/// for the paths of meshes. Throws UsageError for an object from standard input, which has no name.
std::string scene_text(const SceneOptions& options, const std::string& folder);

}  // namespace scanlight::apps
