#pragma once

#include <string>
#include <string_view>

#include "apps/scene/scene_options.h"

namespace scanlight::apps {

/// Takes what a person names as input: a scene file, which is read over the options, or anything
/// that an object may be, which becomes the one object. Scene files end in .toml; "scene:PATH" is
/// one whatever it ends in, and "scene:-" is standard input. Throws FileError "file:line:column:
/// reason" for a scene file that can't be taken as it is.
void set_input(SceneOptions& options, const std::string& input);

/// Whether `input` means a scene file.
bool names_scene(const std::string& input);

/// The same for the text of a scene file, whose paths are meant from `folder` on. Messages call it
/// `name`. What it includes is read first.
void read_scene(SceneOptions& options, std::string_view text, const std::string& name,
                const std::string& folder);

}  // namespace scanlight::apps
