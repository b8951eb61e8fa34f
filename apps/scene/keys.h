#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apps/scene/key_table.h"
#include "apps/scene/scene_options.h"

namespace scanlight::apps {

/// A table of scene files: what it holds, and its way into the options and back.
struct Section {
    std::string name;  // "light"
    std::string meaning;
    std::size_t most = 1;  // tables of this name; more than one stand in [[light]]
    std::vector<KeyInfo> keys;
    KeyRules rules;
    std::function<void(const Table&, const Where&, SceneOptions&)> read;
    /// The lines of each table that has to be written.
    std::function<std::vector<std::string>(const SceneOptions&, const std::filesystem::path&)>
        write;

    bool is_repeated() const { return most > 1; }
    std::string heading() const { return is_repeated() ? "[[" + name + "]]" : "[" + name + "]"; }
};

/// The tables that a scene file may have, and all their keys: the only list of them.
const std::vector<Section>& sections();

}  // namespace scanlight::apps
