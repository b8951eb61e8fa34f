#pragma once

#include <cstddef>
#include <vector>

#include "apps/demo/screen.h"
#include "apps/demo/window/box.h"

namespace scanlight::apps::window {

/// How much a lesson has to show.
struct LessonShape {
    std::size_t panels = 1;
    std::size_t plots = 0;
    std::size_t tables = 0;
    std::size_t walks = 0;

    bool operator==(const LessonShape&) const = default;
};
LessonShape shape_of(const demo::Screen& screen);

/// Where it stands on the canvas: pictures, each below the line of its caption; plots and tables
/// under them, or beside a block of pictures that so becomes larger.
struct LessonLayout {
    std::vector<Box> panels;
    std::vector<Box> plots;
    Box tables;
    Box code;  // of a walk, beside the picture
};

/// All as large as fits.
LessonLayout layout_of(const LessonShape& shape, raster::Viewport canvas);

inline constexpr int caption_height = 24;  // pixels

}  // namespace scanlight::apps::window
