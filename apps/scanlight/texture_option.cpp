#include "apps/scanlight/texture_option.h"

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "apps/scanlight/parse.h"
#include "apps/scanlight/usage_error.h"
#include "raster/load_image.h"
#include "render/texture_image.h"

namespace scanlight::apps {

namespace {

template <class Value>
using Names = std::span<const std::pair<std::string_view, Value>>;

using shading::Filter;
using shading::Mapping;
using shading::Pattern;
using shading::Wrap;

constexpr std::pair<std::string_view, TextureSlot> slots[] = {
    {"diffuse", TextureSlot::diffuse}, {"specular", TextureSlot::specular},
    {"ambient", TextureSlot::ambient}, {"exponent", TextureSlot::exponent},
    {"opacity", TextureSlot::opacity}, {"bump", TextureSlot::bump},
    {"normal", TextureSlot::normal}};
constexpr std::pair<std::string_view, Pattern> patterns[] = {
    {"checker", Pattern::checker},    {"stripes", Pattern::stripes},
    {"gradient", Pattern::gradient},  {"waves", Pattern::waves},
    {"wood", Pattern::wood},          {"marble", Pattern::marble},
    {"cubes", Pattern::solid_checker}};
constexpr std::pair<std::string_view, Mapping> mappings[] = {
    {"uv", Mapping::uv},
    {"planar", Mapping::planar},
    {"cylindrical", Mapping::cylindrical},
    {"chapter-cylinder", Mapping::chapter_cylinder},
    {"spherical", Mapping::spherical}};
constexpr std::pair<std::string_view, Filter> filters[] = {
    {"nearest", Filter::nearest}, {"bilinear", Filter::bilinear}, {"trilinear", Filter::trilinear}};
constexpr std::pair<std::string_view, Wrap> wraps[] = {
    {"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}, {"mirror", Wrap::mirror}};
constexpr std::pair<std::string_view, render::Axis> axes[] = {
    {"x", render::Axis::x}, {"y", render::Axis::y}, {"z", render::Axis::z}};

[[noreturn]] void refuse(std::string_view word, const std::string& expected) {
    throw UsageError("texture '" + std::string(word) + "': expected " + expected);
}

template <class Value, std::size_t n>
Value named(std::string_view word, const std::pair<std::string_view, Value> (&names)[n],
            const std::string& more = {}) {
    std::string list;
    for (const auto& [name, value] : names) {
        if (name == word) return value;
        list += (list.empty() ? "" : ", ") + std::string(name);
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
        option.texture.pattern = named(kind, patterns, ", image:PATH");
        return;
    }
    option.texture.pattern = Pattern::image;
    option.image_path = kind.substr(image.size());
}

void take(std::string_view key, std::string_view value, TextureOption& o) {
    shading::Texture& t = o.texture;
    if (key == "mapping") {
        t.mapping = named(value, mappings);
    } else if (key == "axis") {
        o.axis = named(value, axes);
    } else if (key == "filter") {
        t.filter = named(value, filters);
    } else if (key == "wrap") {
        t.wrap = named(value, wraps);
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

std::shared_ptr<const shading::TexelImage> loaded(const TextureOption& option) {
    const bool is_color = option.slot == TextureSlot::ambient ||
                          option.slot == TextureSlot::diffuse ||
                          option.slot == TextureSlot::specular;
    auto image =
        render::texel_image(raster::load_image(option.image_path),
                            is_color ? render::TexelMeaning::color : render::TexelMeaning::value);
    if (!image)
        throw UsageError(option.image_path + ": a texture has at most " +
                         std::to_string(render::most_texels) + " texels");
    return image;
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

TextureOption parse_texture(std::string_view text) {
    const auto words = words_of(text);
    if (words.empty()) refuse(text, "SLOT=KIND, such as diffuse=checker");
    TextureOption option;
    const auto [slot, kind] = key_and_value(words.front());
    option.slot = named(slot, slots);
    take_kind(kind, option);
    for (const std::string_view word : std::span(words).subspan(1)) {
        const auto [key, value] = key_and_value(word);
        take(key, value, option);
    }
    return option;
}

shading::SurfaceTextures textures_of(const std::vector<TextureOption>& options,
                                     const mesh::Box& bounds) {
    shading::SurfaceTextures textures;
    for (const TextureOption& option : options) {
        const double scale = option.scale * usual_scale(option.texture.pattern);
        shading::Texture texture = render::fitted(option.texture, bounds, option.axis, scale);
        if (texture.pattern == Pattern::image) texture.image = loaded(option);
        slot_of(textures, option.slot) = std::move(texture);
        if (option.slot == TextureSlot::bump) textures.bump_height = option.height;
    }
    return textures;
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
