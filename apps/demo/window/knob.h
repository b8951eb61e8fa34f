#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "apps/scene/key_table.h"
#include "apps/scene/scene_options.h"

namespace scanlight::apps::window {

/// A key of scene files as a way into a picture's options.
struct Knob {
    KeyInfo info;
    /// What the options say, or what holds where they say nothing; none if that is not one value.
    std::function<std::optional<Value>(const SceneOptions&)> get;
    /// False, and nothing is changed, if the value is none for this key.
    std::function<bool(SceneOptions&, const Value&)> set;
};

/// "render", "zoom": one of the keys of that section. `which` is the table among those of one name,
/// such as the second [[light]]. Throws std::invalid_argument for a key that is not there.
Knob knob(const std::string& section, const std::string& key, std::size_t which = 0);

// Values as TOML has them.
Value number_value(double number);
Value whole_value(int number);
Value text_value(const std::string& text);
Value flag_value(bool flag);
Value color_value(const glm::vec3& linear);

// And back; none if the value is of another kind.
std::optional<double> number_of(const Value& value);
std::optional<std::string> text_of(const Value& value);
std::optional<bool> flag_of(const Value& value);
std::optional<glm::vec3> color_of(const Value& value);  // linear

/// "[0.5, 1, 2]" as a value; none for what is not TOML.
std::optional<Value> parsed_value(const std::string& toml);

}  // namespace scanlight::apps::window
