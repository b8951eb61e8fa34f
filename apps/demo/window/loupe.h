#pragma once

#include <memory>
#include <optional>
#include <string>

#include "apps/demo/window/painter.h"
#include "apps/demo/window/state.h"
#include "render/pixel_light.h"

namespace scanlight::apps::window {

/// What lies under the loupe: a pixel of one view's picture.
struct PickedPixel {
    View view = View::left;
    int x = 0;
    int y = 0;
    Point at;  // of the canvas
};

/// The pixel that is held, or that under the mouse; none where no picture is.
std::optional<PickedPixel> picked_pixel(const WindowState& state);

/// Finds out what is at pixels of one view. The buffers that this takes are drawn only when a pixel
/// of a new picture is asked for.
class PixelReader {
public:
    std::optional<render::PixelLight> at(const Painter& painter, const SceneOptions& options, int x,
                                         int y);

private:
    std::string drawn_;
    std::unique_ptr<render::PixelLights> lights_;
};

/// Tells all of it, in a lower corner of the canvas: the pixels about it
/// enlarged, its vectors, each term of its light.
void draw_loupe(const PickedPixel& picked, const std::optional<render::PixelLight>& pixel,
                const Painter& painter, const SceneOptions& options, raster::Viewport canvas);

}  // namespace scanlight::apps::window
