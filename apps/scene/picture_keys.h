#pragma once

#include "apps/scene/key_table.h"
#include "apps/scene/scene_options.h"

namespace scanlight::apps {

// The keys of the tables that say how a picture is taken.

KeyTable<SceneOptions> camera_keys();             // [camera]
KeyTable<CameraKey> camera_key_keys();            // [[camera.key]]
KeyTable<SceneOptions> render_keys();             // [render]
KeyTable<LightOption> light_keys();               // [[light]]
KeyTable<EnvironmentOptions> environment_keys();  // [environment]

}  // namespace scanlight::apps
