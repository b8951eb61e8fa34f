#pragma once

#include <vector>

#include "apps/demo/screen.h"
#include "apps/demo/window/box.h"
#include "raster/project.h"

namespace scanlight::apps::window {

/// What a person sees of a lesson, and so means.
struct LessonSight {
    const demo::Screen& screen;
    std::vector<Box> pictures;  // of the panels, as large as they are
    raster::Viewport panel;     // the size that the lesson was asked for
};

}  // namespace scanlight::apps::window
