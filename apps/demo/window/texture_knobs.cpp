#include "apps/demo/window/texture_knobs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "apps/scene/words.h"

namespace scanlight::apps::window {

namespace {

const std::string none = "none";

/// Its place in the list; none where the slot is empty.
std::optional<std::size_t> texture_in(const SceneOptions& options, TextureSlot slot) {
    const std::string& name = options.material.textures[slot];
    const auto found = std::ranges::find(options.textures, name, &TextureOption::name);
    if (name.empty() || found == options.textures.end()) return std::nullopt;
    return static_cast<std::size_t>(std::distance(options.textures.begin(), found));
}

/// Also takes it off the list, where no one else can name it.
void take_off(SceneOptions& options, TextureSlot slot) {
    const auto place = texture_in(options, slot);
    options.material.textures[slot].clear();
    if (place && options.objects.size() == 1 && options.materials.empty())
        options.textures.erase(options.textures.begin() + static_cast<std::ptrdiff_t>(*place));
}

bool put_on(SceneOptions& options, TextureSlot slot, const std::string& pattern) {
    const auto words = words_beside(shading::Pattern{});
    const bool is_known =
        std::ranges::find(words, pattern, &Words<shading::Pattern>::value_type::first) !=
        words.end();
    if (!is_known && pattern != none) return false;
    take_off(options, slot);
    if (pattern == none) return true;
    auto [place, texture] = parse_texture(word_of(slot) + "=" + pattern);
    add_texture(options, place, std::move(texture));
    return true;
}

Value pattern_on(const SceneOptions& options, TextureSlot slot) {
    const auto place = texture_in(options, slot);
    if (!place) return text_value(none);
    const shading::Pattern pattern = options.textures[*place].texture.pattern;
    return text_value(pattern == shading::Pattern::image ? "image" : word_of(pattern));
}

/// One of the keys of [[texture]].
Knob texture_knob(TextureSlot slot, const std::string& key) {
    const auto get = [=](const SceneOptions& options) -> std::optional<Value> {
        const auto place = texture_in(options, slot);
        return place ? knob("texture", key, *place).get(options) : std::nullopt;
    };
    const auto set = [=](SceneOptions& options, const Value& value) {
        const auto place = texture_in(options, slot);
        return place && knob("texture", key, *place).set(options, value);
    };
    return {knob("texture", key).info, get, set};
}

}  // namespace

Knob pattern_knob(TextureSlot slot) {
    Json words = Json::array({none});
    for (const auto& [word, pattern] : words_beside(shading::Pattern{}))
        words.push_back(word);
    KeyInfo info = knob("texture", "pattern").info;
    info.schema = {{"enum", words}};
    const auto set = [slot](SceneOptions& options, const Value& value) {
        const auto pattern = text_of(value);
        return pattern && put_on(options, slot, *pattern);
    };
    return {
        info,
        [slot](const SceneOptions& options) { return std::optional(pattern_on(options, slot)); },
        set};
}

Knob mapping_knob(TextureSlot slot) {
    return texture_knob(slot, "mapping");
}

Knob count_knob(TextureSlot slot) {
    return texture_knob(slot, "count");
}

Knob bend_knob(TextureSlot slot) {
    return texture_knob(slot, "bend");
}

Knob height_knob(TextureSlot slot) {
    return texture_knob(slot, "height");
}

}  // namespace scanlight::apps::window
