#include "apps/scene/scene_image.h"

#include <stdexcept>

#include "apps/scene/stated.h"
#include "apps/scene/usage_error.h"
#include "raster/load_image.h"

namespace scanlight::apps {

namespace {

raster::AnyImage loaded(const std::string& path, const std::string& stated_at) {
    expect_file(stated_at, "image", path);
    try {
        return raster::load_image(path);
    } catch (const std::runtime_error& error) {
        throw UsageError(prefix_of(stated_at) + error.what());
    }
}

}  // namespace

std::shared_ptr<const shading::TexelImage> scene_image(const std::string& path,
                                                       render::TexelMeaning meaning,
                                                       const std::string& stated_at) {
    auto image = render::texel_image(loaded(path, stated_at), meaning);
    if (!image)
        throw UsageError(prefix_of(stated_at) + path + ": expected at most " +
                         std::to_string(render::most_texels) + " texels");
    return image;
}

}  // namespace scanlight::apps
