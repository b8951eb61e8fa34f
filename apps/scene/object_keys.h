#pragma once

#include "apps/scene/key_table.h"
#include "apps/scene/scene_options.h"

namespace scanlight::apps {

// The keys of the tables that say what a picture shows.

KeyTable<TextureOption> texture_keys();     // [[texture]]
KeyTable<MaterialOptions> material_keys();  // [[material]]
KeyTable<MaterialOptions> surface_keys();   // [surface]: all materials at once
KeyTable<ObjectOptions> object_keys();      // [[object]]

/// Where an object's keys have no value.
inline constexpr const char* as_the_picture = "as in `[render]`";

}  // namespace scanlight::apps
