#pragma once

#include <string>

namespace scanlight::apps {

/// All tables and keys of scene files, as a page in Markdown: docs/scene.md.
std::string scene_reference();

/// The same as a JSON Schema (draft 2020-12), for editors.
std::string scene_schema();

}  // namespace scanlight::apps
