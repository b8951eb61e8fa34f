#pragma once

#include <memory>
#include <string>

#include "render/texture_image.h"
#include "shading/environment.h"

namespace scanlight::apps {

/// The picture in a file as a texture of this meaning. Throws UsageError, which says where it is
/// stated, for a file that is no picture, or too large a one.
std::shared_ptr<const shading::TexelImage> scene_image(const std::string& path,
                                                       render::TexelMeaning meaning,
                                                       const std::string& stated_at);

/// The picture in a file as what is around everything: an environment of this layout, in the axes
/// of a cube or, else, in its own. Throws UsageError as `scene_image`, and for a picture that has
/// not the shape of a cube's sides.
shading::Environment scene_environment(const std::string& path, shading::EnvironmentLayout layout,
                                       const std::string& stated_at);

}  // namespace scanlight::apps
