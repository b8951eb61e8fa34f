#include "apps/demo/stage.h"

#include <utility>
#include <variant>

#include "apps/scanlight/picture.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/scene_setup.h"
#include "raster/compare.h"
#include "render/draw.h"

namespace scanlight::demo {

namespace {

apps::SceneOptions of_size(apps::SceneOptions options, raster::Viewport size) {
    options.size = size;
    return options;
}

}  // namespace

Stage::Stage(std::string arguments, raster::Viewport size)
    : Stage(arguments, apps::parse_scene(arguments), size) {}

Stage::Stage(std::string arguments, apps::SceneOptions options, raster::Viewport size)
    : arguments_(std::move(arguments)),
      options_(of_size(std::move(options), size)),
      models_(apps::load_models(options_)),
      scene_(apps::scene_of(models_, options_)) {}

raster::Image8 Stage::picture(const apps::Means& means) const {
    return apps::byte_image(apps::draw_picture(scene_, options_, means, {}),
                            raster::Alpha::dropped);
}

raster::Framebuffer Stage::framebuffer() const {
    return render::draw(scene_, options_.settings, options_.size).framebuffer;
}

std::string Stage::command(const std::string& more) const {
    return "scanlight render " + arguments_ + " --size " + std::to_string(options_.size.width) +
           "x" + std::to_string(options_.size.height) + more;
}

Panel Stage::panel(const std::string& key, const apps::Means& means) const {
    return {key, picture(means), command()};
}

Panel panel_of(const std::string& key, const std::string& arguments, raster::Viewport size,
               const apps::Means& means) {
    return Stage(arguments, size).panel(key, means);
}

Panel difference_panel(const Panel& first, const Panel& second) {
    const auto with_name = [](const std::string& command, const std::string& name) {
        return command.substr(0, command.rfind("picture.png")) + name;
    };
    return {"difference", raster::difference_image(first.picture, second.picture),
            with_name(first.command, "a.png") + "\n" + with_name(second.command, "b.png") +
                "\nscanlight diff a.png b.png -o difference.png"};
}

}  // namespace scanlight::demo
