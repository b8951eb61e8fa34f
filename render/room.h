#pragma once

#include <memory>

#include "shading/texel_image.h"

namespace scanlight::render {

/// The inside of a room as a picture by latitudes, for an environment without a file: a checkered
/// floor, four walls of different colours, one with a bright window, and a lamp in the ceiling.
std::shared_ptr<const shading::TexelImage> room(int height);

}  // namespace scanlight::render
