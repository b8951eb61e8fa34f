#pragma once

#include <string>
#include <vector>

#include "apps/scene/scene_options.h"

namespace scanlight::apps::window {

struct WindowOptions {
    SceneOptions scene;                    // both views begin as this; its size is the canvas'
    std::string lesson;                    // that it opens with; empty: the scene
    std::vector<std::string> assignments;  // "CONTROL=VALUE", over where the lesson starts
    std::string language = "en";
    int measured_frames = 0;      // turned by so many frames, whose times are printed; 0: not
    std::string snapshot;         // a PNG of the window after its first frames; empty: none
    bool lists_controls = false;  // where each control stands is printed, for scripts
};

/// Opens the window and returns when it is closed, or what is asked for is done: the exit status.
/// Throws UsageError or FileError for the scene, std::runtime_error where there is no display.
int run_window(const WindowOptions& options);

}  // namespace scanlight::apps::window
