#pragma once

#include <memory>
#include <string>

#include "render/texture_image.h"

namespace scanlight::apps {

/// The picture in a file as a texture of this meaning. Throws UsageError, which says where it is
/// stated, for a file that is no picture, or too large a one.
std::shared_ptr<const shading::TexelImage> scene_image(const std::string& path,
                                                       render::TexelMeaning meaning,
                                                       const std::string& stated_at);

}  // namespace scanlight::apps
