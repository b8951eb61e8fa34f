#pragma once

#include "apps/scene/model.h"
#include "render/scene.h"

namespace scanlight::apps {

/// Loads the textures that the model's materials name, from the folder of its file and below. What
/// of the materials cannot be drawn, by this shading too, is added to the model's warnings.
void load_textures(Model& model, render::Shading shading);

}  // namespace scanlight::apps
