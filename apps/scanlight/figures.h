#pragma once

#include <string>
#include <vector>

#include "apps/scanlight/means.h"
#include "raster/image.h"
#include "raster/project.h"

namespace scanlight::apps {

/// A picture of the gallery, which is a golden of the tests too: panels side by side, each drawn by
/// its own command line.
struct Figure {
    std::string name;
    std::string caption;              // what to notice
    std::vector<std::string> panels;  // what follows `scanlight render`
};

const std::vector<Figure>& figures();

/// Draws a figure, each panel of this size.
raster::Image8 draw_figure(const Figure& figure, raster::Viewport panel_size,
                           const Means& means = {});

}  // namespace scanlight::apps
