#include "apps/scene/write_scene.h"

#include "apps/scene/keys.h"

namespace scanlight::apps {

std::string scene_text(const SceneOptions& options, const std::string& folder) {
    std::string text;
    for (const Section& section : sections()) {
        for (const std::string& lines : section.write(options, folder))
            text += (text.empty() ? "" : "\n") + section.heading() + "\n" + lines;
    }
    return text;
}

}  // namespace scanlight::apps
