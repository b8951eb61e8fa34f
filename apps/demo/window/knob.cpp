#include "apps/demo/window/knob.h"

#include <algorithm>
#include <stdexcept>

#include "apps/scene/object_keys.h"
#include "apps/scene/parse.h"
#include "apps/scene/picture_keys.h"
#include "mesh/file_error.h"

namespace scanlight::apps::window {

namespace {

/// Of the part of the options that `access` finds.
template <class Owner, class Access>
Knob knob_of(const KeyTable<Owner>& table, const std::string& name, Access access) {
    const auto found =
        std::ranges::find(table.keys, name, [](const auto& key) { return key.info.name; });
    if (found == table.keys.end()) throw std::invalid_argument("no key '" + name + "'");
    const Key<Owner> key = *found;
    const auto get = [key, access](const SceneOptions& options) {
        const std::string said = key.get(access(options), {});
        return parsed_value(said.empty() ? key.info.fallback : said);
    };
    const auto set = [key, access](SceneOptions& options, const Value& value) {
        return key.set(access(options), value, {});
    };
    return {key.info, get, set};
}

/// Of one table of a list of the options, which has it.
template <class Owner>
Knob knob_in(const KeyTable<Owner>& table, const std::string& name,
             std::vector<Owner> SceneOptions::*list, std::size_t which) {
    return knob_of(
        table, name, [ list, which ](auto& options) -> auto& { return (options.*list).at(which); });
}

}  // namespace

Knob knob(const std::string& section, const std::string& key, std::size_t which) {
    const auto all = [](auto& options) -> auto& {
        return options;
    };
    if (section == "camera") return knob_of(camera_keys(), key, all);
    if (section == "render") return knob_of(render_keys(), key, all);
    if (section == "surface")
        return knob_of(
            surface_keys(), key, [](auto& options) -> auto& { return options.material; });
    if (section == "environment")
        return knob_of(
            environment_keys(), key, [](auto& options) -> auto& { return options.environment; });
    if (section == "light") return knob_in(light_keys(), key, &SceneOptions::lights, which);
    if (section == "texture") return knob_in(texture_keys(), key, &SceneOptions::textures, which);
    throw std::invalid_argument("no section '" + section + "'");
}

// ---- values

Value number_value(double number) {
    return {{}, number};
}

Value whole_value(int number) {
    return {{}, std::int64_t{number}};
}

Value text_value(const std::string& text) {
    return {{}, text};
}

Value flag_value(bool flag) {
    return {{}, flag};
}

Value color_value(const glm::vec3& linear) {
    return {{}, Array{number_value(linear.r), number_value(linear.g), number_value(linear.b)}};
}

std::optional<double> number_of(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.is))
        return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(&value.is);
    return number != nullptr ? std::optional(*number) : std::nullopt;
}

std::optional<std::string> text_of(const Value& value) {
    const auto* text = std::get_if<std::string>(&value.is);
    return text != nullptr ? std::optional(*text) : std::nullopt;
}

std::optional<bool> flag_of(const Value& value) {
    const bool* flag = std::get_if<bool>(&value.is);
    return flag != nullptr ? std::optional(*flag) : std::nullopt;
}

std::optional<glm::vec3> color_of(const Value& value) {
    if (const auto grey = number_of(value)) return glm::vec3(static_cast<float>(*grey));
    if (const auto text = text_of(value); text && text->starts_with('#')) return parse_color(*text);
    const auto* channels = std::get_if<Array>(&value.is);
    if (channels == nullptr || channels->size() != 3) return std::nullopt;
    glm::vec3 color;
    for (int k = 0; k < 3; ++k) {
        const auto channel = number_of((*channels)[static_cast<std::size_t>(k)]);
        if (!channel) return std::nullopt;
        color[k] = static_cast<float>(*channel);
    }
    return color;
}

std::optional<Value> parsed_value(const std::string& toml) {
    try {
        const Table table = parse_document("value = " + toml, "value");
        const Entry* entry = find(table, "value");
        return entry != nullptr ? std::optional(entry->value) : std::nullopt;
    } catch (const mesh::FileError&) {  // "the mesh's own"
        return std::nullopt;
    }
}

}  // namespace scanlight::apps::window
