#pragma once

#include <string>

#include "apps/scanlight/picture.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/models.h"

namespace scanlight::apps {

/// What `--stats` tells of one run.
struct Statistics {
    const Models& models;
    const SceneOptions& options;
    PictureReport picture;
    double draw_seconds;
    double save_seconds;
};

std::string as_json(const Statistics& statistics);
std::string as_text(const Statistics& statistics);

/// One line for a person: "teapot.png: 640x480, 2016 polygons drawn in 12.3 ms".
std::string summary(const std::string& output, const Statistics& statistics);

}  // namespace scanlight::apps
