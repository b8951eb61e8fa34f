#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/demo/lesson.h"
#include "apps/demo/texts.h"
#include "apps/scanlight/means.h"
#include "raster/project.h"

namespace scanlight::demo {

/// How the course is written as a page.
struct PageOptions {
    Language language = Language::english;  // it begins in; the page has both
    raster::Viewport panel_size{320, 240};
    apps::Means means;
};

/// Lessons as one HTML file that needs no other, nor a network: each lesson's screens at
/// all stops of its controls, pictures as data. `now` is told what is being drawn.
std::string course_page(const std::vector<Lesson>& lessons, const PageOptions& options,
                        const std::function<void(const std::string&)>& now);

}  // namespace scanlight::demo
