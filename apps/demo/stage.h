#pragma once

#include <string>

#include "apps/demo/screen.h"
#include "apps/scanlight/means.h"
#include "apps/scene/models.h"
#include "apps/scene/scene_options.h"
#include "raster/framebuffer.h"
#include "render/scene.h"

namespace scanlight::demo {

/// What a command line puts before the camera: its options, meshes and scene. The scene points into
/// the meshes, so a stage stays where it is.
class Stage {
public:
    /// `arguments` are what follows `scanlight render`. Throws as that does.
    Stage(std::string arguments, raster::Viewport size);
    /// Of a scene file that the program brings along, as `arguments` name it.
    Stage(std::string arguments, apps::SceneOptions options, raster::Viewport size);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    const std::string& arguments() const { return arguments_; }
    const apps::SceneOptions& options() const { return options_; }
    const apps::Models& models() const { return models_; }
    const render::Scene& scene() const { return scene_; }

    /// As `scanlight render` draws it.
    raster::Image8 picture(const apps::Means& means) const;

    /// The same before it is clamped and encoded: linear light, with the depths.
    raster::Framebuffer framebuffer() const;

    /// "scanlight render ARGUMENTS --size WxH" and `more`.
    std::string command(const std::string& more = " -o picture.png") const;

    Panel panel(const std::string& key, const apps::Means& means) const;

private:
    std::string arguments_;
    apps::SceneOptions options_;
    apps::Models models_;
    render::Scene scene_;
};

/// The panel that a command line draws.
Panel panel_of(const std::string& key, const std::string& arguments, raster::Viewport size,
               const apps::Means& means);

/// Where two panels differ, as `scanlight diff` draws it.
Panel difference_panel(const Panel& first, const Panel& second);

}  // namespace scanlight::demo
