#include "apps/scene/parse.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "apps/scene/usage_error.h"
#include "raster/srgb.h"

namespace scanlight::apps {

namespace {

// Beyond these nothing is meant, and what a float makes of it is not a number any more.
constexpr double largest_number = 1e30;
constexpr double largest_intensity = 1e6;

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

[[noreturn]] void refuse(std::string_view what, std::string_view text, std::string_view expected) {
    throw UsageError(std::string(what) + " '" + std::string(text) + "': expected " +
                     std::string(expected));
}

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return std::abs(value) <= largest_number ? std::optional(value) : std::nullopt;  // no NaN
}

std::optional<int> pixels(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value >= 1 && value <= raster::max_size ? std::optional(value) : std::nullopt;
}

std::optional<glm::dvec3> three_numbers(const std::vector<std::string_view>& parts) {
    if (parts.size() < 3) return std::nullopt;
    const auto x = number(parts[0]);
    const auto y = number(parts[1]);
    const auto z = number(parts[2]);
    if (!x || !y || !z) return std::nullopt;
    return glm::dvec3(*x, *y, *z);
}

std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
    std::uint32_t value = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return value;
}

glm::vec3 linear_from_bytes(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    const auto linear = [](std::uint32_t byte) {
        return raster::linear_from_srgb(static_cast<std::uint8_t>(byte));
    };
    return {linear(red), linear(green), linear(blue)};
}

std::optional<glm::vec3> hash_color(std::string_view text) {
    const auto value = hexadecimal(text.substr(1));
    if (!value) return std::nullopt;
    const std::uint32_t v = *value;
    if (text.size() == 7) return linear_from_bytes(v >> 16, v >> 8 & 255, v & 255);
    if (text.size() == 4) {
        return linear_from_bytes((v >> 8) * 17, (v >> 4 & 15) * 17, (v & 15) * 17);
    }
    return std::nullopt;
}

bool is_intensity(double value) {
    return value >= 0.0 && value <= largest_intensity;
}

std::optional<glm::vec3> number_color(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() == 1) {
        const auto grey = number(text);
        return grey && is_intensity(*grey) ? std::optional(glm::vec3(static_cast<float>(*grey)))
                                           : std::nullopt;
    }
    const auto color = parts.size() == 3 ? three_numbers(parts) : std::nullopt;
    const bool valid =
        color && is_intensity(color->x) && is_intensity(color->y) && is_intensity(color->z);
    return valid ? std::optional(glm::vec3(*color)) : std::nullopt;
}

LightFrame take_light_frame(std::string_view& text) {
    const std::pair<std::string_view, LightFrame> frames[] = {{"camera:", LightFrame::camera},
                                                              {"world:", LightFrame::world},
                                                              {"point:", LightFrame::point}};
    for (const auto& [prefix, frame] : frames) {
        if (text.starts_with(prefix)) {
            text.remove_prefix(prefix.size());
            return frame;
        }
    }
    return LightFrame::camera;
}

std::optional<shading::Falloff> falloff_named(std::string_view name) {
    if (name == "constant") return shading::Falloff::constant;
    if (name == "inverse") return shading::Falloff::inverse;
    if (name == "inverse-square") return shading::Falloff::inverse_square;
    if (name == "inverse-plus-k") return shading::Falloff::inverse_plus_k;
    return std::nullopt;
}

constexpr std::string_view material_words =
    "ka=…, kd=…, ks=…, n=…, mirror=…, refract=…, opacity=…, tf=…, kdt=…, kt=… or nt=…";

std::optional<glm::vec3>* color_named(std::string_view key, MaterialOptions& material) {
    if (key == "ka") return &material.ambient;
    if (key == "kd") return &material.diffuse;
    if (key == "ks") return &material.specular;
    if (key == "mirror") return &material.mirror;
    if (key == "refract") return &material.refracted;
    if (key == "tf") return &material.filter;
    if (key == "kdt") return &material.transmitted_diffuse;
    if (key == "kt") return &material.transmitted_specular;
    return nullptr;
}

float parse_opacity(std::string_view text) {
    const auto opacity = static_cast<float>(parse_number(text, "material opacity"));
    if (!(opacity >= 0.0f && opacity <= 1.0f))
        refuse("material opacity", text, "a number from 0 to 1");
    return opacity;
}

std::optional<double>* exponent_named(std::string_view key, MaterialOptions& material) {
    if (key == "n") return &material.exponent;
    if (key == "nt") return &material.transmitted_exponent;
    return nullptr;
}

double parse_exponent(std::string_view key, std::string_view value) {
    const std::string what = "material " + std::string(key);
    const double exponent = parse_number(value, what);
    if (exponent < 0.0) refuse(what, value, "0 or more");
    return exponent;
}

}  // namespace

double parse_number(std::string_view text, std::string_view what) {
    const auto value = number(text);
    if (!value) refuse(what, text, "a number");
    return *value;
}

raster::Viewport parse_size(std::string_view text) {
    const auto parts = split(text, 'x');
    const auto width = parts.size() == 2 ? pixels(parts[0]) : std::nullopt;
    const auto height = parts.size() == 2 ? pixels(parts[1]) : std::nullopt;
    if (!width || !height) refuse("size", text, "WIDTHxHEIGHT, each 1 to 16384, such as 640x480");
    return {*width, *height};
}

int parse_samples(std::string_view text) {
    for (const int grid : {1, 2, 4}) {
        if (text == std::to_string(grid * grid)) return grid;
    }
    refuse("samples", text, "1, 4 or 16");
}

render::ViewAngles parse_view(std::string_view text) {
    const auto parts = split(text, ',');
    const auto azimuth = parts.size() == 2 ? number(parts[0]) : std::nullopt;
    const auto elevation = parts.size() == 2 ? number(parts[1]) : std::nullopt;
    if (!azimuth || !elevation || std::abs(*azimuth) > 36000.0 || std::abs(*elevation) > 90.0) {
        refuse("view", text, "AZIMUTH,ELEVATION in degrees, elevation -90 to 90, such as 30,20");
    }
    return {*azimuth, *elevation};
}

glm::dvec3 parse_point(std::string_view text, std::string_view what) {
    const auto parts = split(text, ',');
    const auto point = parts.size() == 3 ? three_numbers(parts) : std::nullopt;
    if (!point) refuse(what, text, "x,y,z");
    return *point;
}

glm::vec3 parse_color(std::string_view text) {
    const auto color = text.starts_with('#') ? hash_color(text) : number_color(text);
    if (!color) refuse("colour", text, "#rrggbb, #rgb, one grey number or r,g,b");
    return *color;
}

LightOption parse_light(std::string_view text) {
    constexpr std::string_view expected =
        "[camera:|world:|point:]x,y,z[,#colour][,constant|inverse|inverse-square|inverse-plus-k]";
    LightOption light;
    std::string_view rest = text;
    light.frame = take_light_frame(rest);
    const auto parts = split(rest, ',');
    const auto place = three_numbers(parts);
    if (!place) refuse("light", text, expected);
    light.place = *place;
    for (std::size_t i = 3; i < parts.size(); ++i) {
        if (parts[i].starts_with('#')) {
            light.color = parse_color(parts[i]);
        } else if (const auto falloff = falloff_named(parts[i])) {
            light.falloff = *falloff;
        } else {
            refuse("light", text, expected);
        }
    }
    const bool is_point = light.frame == LightFrame::point;
    if (!is_point && light.falloff != shading::Falloff::constant) {
        refuse("light", text, "point: before a place, for a light at infinity has no fall-off");
    }
    if (!is_point && light.place == glm::dvec3(0.0))
        refuse("light", text, "a direction that is not 0,0,0");
    return light;
}

MaterialOptions parse_material(std::string_view text) {
    MaterialOptions material;
    for (const std::string_view word : split(text, ' ')) {
        if (word.empty()) continue;
        const auto parts = split(word, '=');
        if (parts.size() != 2) refuse("material", word, material_words);
        const auto [key, value] = std::pair(parts[0], parts[1]);
        if (std::optional<double>* exponent = exponent_named(key, material)) {
            *exponent = parse_exponent(key, value);
        } else if (std::optional<glm::vec3>* color = color_named(key, material)) {
            *color = parse_color(value);
        } else if (key == "opacity") {
            material.opacity = parse_opacity(value);
        } else {
            refuse("material", word, material_words);
        }
    }
    return material;
}

std::string metal_names() {
    std::string names;
    for (const shading::Metal& metal : shading::metals())
        names += (names.empty() ? "" : ", ") + std::string(metal.name);
    return names;
}

const shading::Metal& parse_metal(std::string_view text) {
    const auto found = std::ranges::find(shading::metals(), text, &shading::Metal::name);
    if (found == shading::metals().end()) refuse("metal", text, "one of " + metal_names());
    return *found;
}

}  // namespace scanlight::apps
