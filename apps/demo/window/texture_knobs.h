#pragma once

#include "apps/demo/window/knob.h"
#include "apps/scene/texture_option.h"

namespace scanlight::apps::window {

// The texture that is laid on all objects in one slot, over their own.

/// "none", or what it is made of.
Knob pattern_knob(TextureSlot slot);

// Without a texture there, these have no value and take none.
Knob mapping_knob(TextureSlot slot);
Knob count_knob(TextureSlot slot);
Knob bend_knob(TextureSlot slot);
Knob height_knob(TextureSlot slot);

}  // namespace scanlight::apps::window
