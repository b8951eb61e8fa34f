#include "apps/demo/window/command_line.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <vector>

#include "apps/demo/window/saving.h"
#include "apps/scanlight/scene_options.h"
#include "apps/scene/model.h"
#include "apps/scene/object_keys.h"
#include "apps/scene/picture_keys.h"
#include "apps/scene/words.h"
#include "apps/scene/write_scene.h"
#include "raster/srgb.h"

namespace scanlight::apps::window {

namespace {

// The command line says what the keys of scene files say, mostly by the same names.

/// An option whose name is not the key's, with - for _.
struct Renamed {
    const char* key;
    const char* option;
};
constexpr Renamed renamed[] = {{"fov_deg", "--fov"},
                               {"lens_mm", "--lens"},
                               {"crease_deg", "--crease"},
                               {"image", "--environment"},
                               {"built_in", "--environment"},
                               {"layout", "--environment-layout"},
                               {"light", "--environment-light"},
                               {"seen_from", "--environment-from"},
                               {"own_textures", "--no-textures"}};

std::string option_name(std::string key) {
    const auto found = std::ranges::find(renamed, key, &Renamed::key);
    if (found != std::end(renamed)) return found->option;
    std::ranges::replace(key, '_', '-');
    return "--" + key;
}

/// A TOML value as the command line has it: "phong" without quotes, [1, 2] as 1,2.
std::string bare(const std::string& toml) {
    std::string text;
    std::ranges::copy_if(toml, std::back_inserter(text),
                         [](char c) { return c != '"' && c != '[' && c != ']' && c != ' '; });
    return text;
}

/// As one word for a shell.
std::string shell_word(const std::string& word) {
    const auto is_plain = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               std::string("-_./,:=+").find(c) != std::string::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

/// " --zoom 2", " --floor", " --size 640x480", " --wireframe=over".
std::string option_text(const std::string& key, const std::string& toml) {
    const std::string name = option_name(key);
    if (toml == "true" || key == "own_textures") return " " + name;
    std::string value = bare(toml);
    if (key == "size") std::ranges::replace(value, ',', 'x');
    return " " + name + (key == "wireframe" ? "=" : " ") + shell_word(value);
}

template <class Owner>
std::string options_text(const KeyTable<Owner>& table, const Owner& owner) {
    std::string text;
    for (const Key<Owner>& key : table.keys) {
        const std::string toml = key.get(owner, {});
        if (!toml.empty()) text += option_text(key.info.name, toml);
    }
    return text;
}

/// The keys of a surface that are words of --material.
bool is_material_word(const std::string& key) {
    const auto words = {"ka", "kd", "ks", "n", "mirror", "refract", "opacity", "kdt", "kt", "nt"};
    return std::ranges::find(words, key) != words.end();
}

std::string surface_text(const MaterialOptions& surface) {
    std::string material;
    std::string rest;
    for (const auto& key : surface_keys().keys) {
        const std::string toml = key.get(surface, {});
        const std::string& name = key.info.name;
        if (toml.empty() || name.ends_with("_texture")) continue;
        if (is_material_word(name)) {
            material += (material.empty() ? "" : " ") + name + "=" + bare(toml);
        } else {
            rest += option_text(name, toml);
        }
    }
    return (material.empty() ? "" : " --material " + shell_word(material)) + rest;
}

/// "diffuse=wood scale=3"
std::string texture_text(TextureSlot slot, const TextureOption& texture) {
    std::string text = word_of(slot) + "=";
    for (const auto& key : texture_keys().keys) {
        const std::string toml = key.get(texture, {});
        const std::string& name = key.info.name;
        if (toml.empty() || name == "name") continue;
        if (name == "pattern") {
            text += bare(toml);
        } else if (name == "image") {
            text += "image:" + texture.image_path;
        } else {
            text += " " + name + "=" + bare(toml);
        }
    }
    return text;
}

std::string textures_text(const SceneOptions& options) {
    std::string text;
    for (const auto& [word, slot] : words_beside(TextureSlot{})) {
        const std::string& name = options.material.textures[slot];
        const auto found = std::ranges::find(options.textures, name, &TextureOption::name);
        if (found != options.textures.end())
            text += " --texture " + shell_word(texture_text(slot, *found));
    }
    return text;
}

std::string hash_of(const glm::vec3& linear) {
    std::string text = "#";
    for (int k = 0; k < 3; ++k) {
        const int byte = raster::srgb_from_linear(linear[k]);
        for (const int digit : {byte / 16, byte % 16})
            text += "0123456789abcdef"[digit];
    }
    return text;
}

std::string light_text(const LightOption& light) {
    const char* frames[] = {"", "world:", "point:"};
    std::string text = frames[static_cast<std::size_t>(light.frame)];
    text += bare(point().write(light.place, {}));
    if (light.color != glm::vec3(1.0f)) text += "," + hash_of(light.color);
    if (light.falloff != shading::Falloff::constant) text += "," + word_of(light.falloff);
    return " --light " + shell_word(text);
}

/// All of it, whether or not the options can tell.
std::string attempted_arguments(const SceneOptions& options) {
    const std::string& input = options.objects.front().input;
    std::string text = shell_word(input) + options_text(camera_keys(), options) +
                       options_text(render_keys(), options) + surface_text(options.material) +
                       textures_text(options);
    for (const LightOption& light : options.lights)
        text += light_text(light);
    return text + options_text(environment_keys(), options.environment);
}

/// Without textures that no surface names.
SceneOptions without_idle_textures(SceneOptions options) {
    std::erase_if(options.textures, [&](const TextureOption& texture) {
        const auto is_named = [&](const MaterialOptions& m) {
            return std::ranges::find(m.textures, texture.name) != m.textures.end();
        };
        const auto names_it = [&](const ObjectOptions& object) {
            return std::ranges::find(object.textures, texture.name) != object.textures.end();
        };
        return !is_named(options.material) && !std::ranges::any_of(options.materials, is_named) &&
               !std::ranges::any_of(options.objects, names_it);
    });
    return options;
}

/// What only models know that draw nothing here. A metal stays: it colours the body too.
SceneOptions without_idle_facets(SceneOptions options) {
    const auto models = models_in(options);
    if (std::ranges::find(models, shading::Illumination::cook_torrance) != models.end())
        return options;
    FacetOptions& facets = options.material.facets;
    facets.roughness.reset();
    facets.distribution.reset();
    facets.constant.reset();
    facets.form.reset();
    facets.specular_share.reset();
    return options;
}

/// The same picture, without what was said of things that it does not show.
SceneOptions without_idle(SceneOptions options) {
    if (options.settings.shadows != render::Shadows::map) options.settings.shadow_map = {};
    return without_idle_facets(without_idle_textures(std::move(options)));
}

/// Whether the program makes the same picture of them.
bool say_all(const std::string& arguments, const SceneOptions& options) {
    try {
        return scene_text(without_idle_textures(parse_scene(arguments)), "") ==
               scene_text(options, "");
    } catch (const std::exception&) {
        return false;
    }
}

std::string output_of(const SceneOptions& options) {
    return shell_word(stem_of(options.objects.front().input) + ".png");
}

}  // namespace

std::string arguments_of(const SceneOptions& options) {
    if (options.objects.size() != 1) return "";
    const SceneOptions shown = without_idle(options);
    const std::string arguments = attempted_arguments(shown);
    return say_all(arguments, shown) ? arguments : "";
}

std::string command_line_of(const SceneOptions& options) {
    const std::string scene = scene_text(options, "");
    const std::string arguments = arguments_of(options);
    if (!arguments.empty()) return "scanlight render " + arguments + " -o " + output_of(options);
    const std::string output = options.objects.empty() ? "picture.png" : output_of(options);
    return "scanlight render scene:- -o " + output + " <<'END'\n" + scene + "END";
}

}  // namespace scanlight::apps::window
