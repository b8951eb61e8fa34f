#include "apps/scene/scene_image.h"

#include <stdexcept>

#include "apps/scene/stated.h"
#include "apps/scene/usage_error.h"
#include "raster/load_image.h"
#include "render/cube_image.h"

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

[[noreturn]] void refuse_size(const std::string& path, const std::string& stated_at) {
    throw UsageError(prefix_of(stated_at) + path + ": expected at most " +
                     std::to_string(render::most_texels) + " texels");
}

shading::Environment scene_cube(const std::string& path, const std::string& stated_at) {
    const auto sides = render::cube_sides(loaded(path, stated_at));
    if (!sides)
        throw UsageError(prefix_of(stated_at) + path +
                         ": expected the six sides of a cube: in a row of 6 x 1, a column of "
                         "1 x 6, or a cross of 4 x 3 or 3 x 4 squares");
    const auto environment = render::cube_environment(*sides);
    if (!environment) refuse_size(path, stated_at);
    return *environment;
}

}  // namespace

std::shared_ptr<const shading::TexelImage> scene_image(const std::string& path,
                                                       render::TexelMeaning meaning,
                                                       const std::string& stated_at) {
    auto image = render::texel_image(loaded(path, stated_at), meaning);
    if (!image) refuse_size(path, stated_at);
    return image;
}

shading::Environment scene_environment(const std::string& path, shading::EnvironmentLayout layout,
                                       const std::string& stated_at) {
    if (layout == shading::EnvironmentLayout::cube) return scene_cube(path, stated_at);
    return {layout, {scene_image(path, render::TexelMeaning::color, stated_at)}, glm::mat3(1.0f)};
}

}  // namespace scanlight::apps
