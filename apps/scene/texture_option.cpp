#include "apps/scene/texture_option.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "apps/scene/parse.h"
#include "apps/scene/scene_image.h"
#include "apps/scene/usage_error.h"
#include "apps/scene/words.h"
#include "shading/slopes.h"

namespace scanlight::apps {

namespace {

using shading::Pattern;

[[noreturn]] void refuse(std::string_view word, const std::string& expected) {
    throw UsageError("texture '" + std::string(word) + "': expected " + expected);
}

template <class Value>
Value named(std::string_view word, const std::string& more = {}) {
    std::string list;
    for (const auto& [name, value] : words_beside(Value{})) {
        if (name == word) return value;
        list += (list.empty() ? "" : ", ") + name;
    }
    refuse(word, "one of " + list + more);
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0) words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

std::pair<std::string_view, std::string_view> key_and_value(std::string_view word) {
    const std::size_t equals = word.find('=');
    if (equals == word.npos) refuse(word, "key=value");
    return {word.substr(0, equals), word.substr(equals + 1)};
}

float number_within(std::string_view text, std::string_view key, double low, double high) {
    const double number = parse_number(text, "texture " + std::string(key));
    if (!(number >= low && number <= high))
        refuse(std::string(key) + "=" + std::string(text),
               "a number from " + std::to_string(low) + " to " + std::to_string(high));
    return static_cast<float>(number);
}

/// "2" or "2,3".
glm::vec2 one_or_two(std::string_view text, std::string_view key) {
    const std::size_t comma = text.find(',');
    const float u = number_within(text.substr(0, comma), key, -10000, 10000);
    return {u, comma == text.npos ? u : number_within(text.substr(comma + 1), key, -10000, 10000)};
}

void take_kind(std::string_view kind, TextureOption& option) {
    constexpr std::string_view image = "image:";
    if (!kind.starts_with(image)) {
        option.texture.pattern = named<Pattern>(kind, ", image:PATH");
        return;
    }
    option.texture.pattern = Pattern::image;
    option.image_path = kind.substr(image.size());
}

void take(std::string_view key, std::string_view value, TextureOption& o) {
    shading::Texture& t = o.texture;
    if (key == "mapping") {
        t.mapping = named<shading::Mapping>(value);
    } else if (key == "axis") {
        o.axis = named<render::Axis>(value);
    } else if (key == "filter") {
        t.filter = named<shading::Filter>(value);
    } else if (key == "wrap") {
        t.wrap = named<shading::Wrap>(value);
    } else if (key == "low") {
        t.low = parse_color(value);
    } else if (key == "high") {
        t.high = parse_color(value);
    } else if (key == "repeat") {
        t.repeat = one_or_two(value, key);
    } else if (key == "offset") {
        t.offset = one_or_two(value, key);
    } else if (key == "count") {
        t.count = number_within(value, key, 1, 10000);
    } else if (key == "bend") {
        t.bend = number_within(value, key, 0, 1000);
    } else if (key == "scale") {
        o.scale = number_within(value, key, 1e-6, 1e6);
    } else if (key == "height") {
        o.height = number_within(value, key, -1e6, 1e6);
    } else {
        refuse(key,
               "mapping, axis, filter, wrap, low, high, repeat, offset, count, bend, scale or "
               "height");
    }
}

/// A trunk is hundreds of units wide, and marble has some layers.
double usual_scale(Pattern pattern) {
    switch (pattern) {
        case Pattern::wood:
            return 300.0;
        case Pattern::marble:
        case Pattern::solid_checker:
            return 4.0;
        default:
            return 1.0;
    }
}

render::TexelMeaning meaning_in(TextureSlot slot) {
    const bool is_color = slot == TextureSlot::ambient || slot == TextureSlot::diffuse ||
                          slot == TextureSlot::specular;
    return is_color ? render::TexelMeaning::color : render::TexelMeaning::value;
}

std::optional<shading::Texture>& slot_of(shading::SurfaceTextures& textures, TextureSlot slot) {
    switch (slot) {
        case TextureSlot::ambient:
            return textures.ambient;
        case TextureSlot::specular:
            return textures.specular;
        case TextureSlot::exponent:
            return textures.exponent;
        case TextureSlot::opacity:
            return textures.opacity;
        case TextureSlot::bump:
            return textures.bump;
        case TextureSlot::normal:
            return textures.normal;
        default:
            return textures.diffuse;
    }
}

}  // namespace

std::pair<TextureSlot, TextureOption> parse_texture(std::string_view text) {
    const auto words = words_of(text);
    if (words.empty()) refuse(text, "SLOT=KIND, such as diffuse=checker");
    TextureOption option;
    const auto [slot_word, kind] = key_and_value(words.front());
    const auto slot = named<TextureSlot>(slot_word);
    take_kind(kind, option);
    for (const std::string_view word : std::span(words).subspan(1)) {
        const auto [key, value] = key_and_value(word);
        take(key, value, option);
    }
    return {slot, option};
}

SlotNames laid_over(SlotNames below, const SlotNames& above) {
    for (const auto& [word, slot] : words_beside(TextureSlot{})) {
        if (!above[slot].empty()) below[slot] = above[slot];
    }
    return below;
}

TextureImages::Image TextureImages::image(const TextureOption& option, TextureSlot slot) {
    auto& image = images_[{option.image_path, meaning_in(slot)}];
    if (image == nullptr)
        image = scene_image(option.image_path, meaning_in(slot), option.stated.at({"image"}));
    return slot == TextureSlot::bump ? slopes(option, image) : image;
}

TextureImages::Image TextureImages::slopes(const TextureOption& option, const Image& heights) {
    const shading::Wrap wrap = option.texture.wrap;
    auto& image = slopes_[{option.image_path, wrap}];
    if (image == nullptr)
        image = std::make_shared<const shading::TexelImage>(shading::slopes_of(*heights, wrap));
    return image;
}

void put(const TextureOption& option, TextureSlot slot, const mesh::Box& bounds,
         TextureImages& images, shading::SurfaceTextures& textures) {
    const double scale = option.scale * usual_scale(option.texture.pattern);
    shading::Texture texture = render::fitted(option.texture, bounds, option.axis, scale);
    if (texture.pattern == Pattern::image) texture.image = images.image(option, slot);
    slot_of(textures, slot) = std::move(texture);
    if (slot == TextureSlot::bump) textures.bump_height = option.height;
}

shading::SurfaceTextures laid_over(shading::SurfaceTextures below,
                                   const shading::SurfaceTextures& above) {
    using Textures = shading::SurfaceTextures;
    for (const auto slot :
         {&Textures::ambient, &Textures::diffuse, &Textures::specular, &Textures::exponent,
          &Textures::opacity, &Textures::emission, &Textures::bump, &Textures::normal}) {
        if (above.*slot) below.*slot = above.*slot;
    }
    if (above.bump) below.bump_height = above.bump_height;
    if (above.normal) below.normal_scale = above.normal_scale;
    return below;
}

}  // namespace scanlight::apps
