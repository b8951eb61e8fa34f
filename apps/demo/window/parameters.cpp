#include "apps/demo/window/parameters.h"

#include <algorithm>
#include <utility>

#include "apps/demo/window/texture_knobs.h"
#include "apps/scene/words.h"
#include "raster/srgb.h"

namespace scanlight::apps::window {

namespace {

using Material = shading::Material<float>;
using enum shading::Illumination;

std::vector<std::string> words_in(const Knob& knob) {
    const Json& schema = knob.info.schema;
    return schema.contains("enum") ? schema["enum"].get<std::vector<std::string>>()
                                   : std::vector<std::string>{};
}

// ---- kinds of parameters

Parameter choice(const std::string& group, const std::string& section, const std::string& key) {
    Parameter p{group, key, "", knob(section, key)};
    p.control = Control::choice;
    p.words = words_in(p.knob);
    std::ranges::replace(p.name, '_', ' ');
    return p;
}

Parameter check(const std::string& group, const std::string& section, const std::string& key) {
    Parameter p = choice(group, section, key);
    p.control = Control::check;
    return p;
}

struct Range {
    double low;
    double high;
    Scale scale = Scale::linear;
};

Parameter slider(const std::string& group, const std::string& section, const std::string& key,
                 const std::string& symbol, Range range) {
    Parameter p = choice(group, section, key);
    p.control = Control::slider;
    p.symbol = symbol;
    p.low = range.low;
    p.high = range.high;
    p.scale = range.scale;
    return p;
}

Parameter whole_slider(const std::string& group, const std::string& section, const std::string& key,
                       Range range) {
    Parameter p = slider(group, section, key, "", range);
    p.control = Control::whole_slider;
    return p;
}

Parameter color(const std::string& group, const std::string& section, const std::string& key,
                const std::string& symbol, const std::string& name) {
    Parameter p = slider(group, section, key, symbol, {0.0, 1.0});
    p.control = Control::color;
    p.name = name;
    return p;
}

// ---- what is added to them

Parameter named(Parameter p, const std::string& name) {
    p.name = name;
    return p;
}

Parameter of(Parameter p, std::vector<shading::Illumination> models) {
    p.models = std::move(models);
    return p;
}

template <class Wanted>
Parameter where(Wanted wanted, Parameter p) {
    p.wanted = wanted;
    return p;
}

template <class Clear>
Parameter or_unsaid(Parameter p, const std::string& word, Clear clear) {
    p.unsaid = word;
    p.clear = clear;
    if (p.control == Control::choice) p.words.insert(p.words.begin(), word);
    return p;
}

/// Of a surface, whose own material says what holds otherwise.
template <class Actual>
Parameter by_material(Parameter p, Actual actual) {
    p.actual = actual;
    return p;
}

// ---- groups

/// Of a light whose fall-off knows k.
bool has_soft_fall_off(const SceneOptions& options) {
    return std::ranges::any_of(lights_in(options), [](const LightOption& light) {
        return light.falloff == shading::Falloff::inverse_plus_k;
    });
}

std::vector<Parameter> light_models() {
    const std::string g = "Shading";
    return {
        choice(g, "render", "shading"),
        choice(g, "render", "illumination"),
        of(slider(g, "render", "gouraud71_k", "k", {0.05, 20.0, Scale::logarithmic}), {gouraud71}),
        choice(g, "render", "distances"),
        color(g, "render", "ambient", "I_a", "ambient light"),
        where(has_soft_fall_off,
              named(slider(g, "render", "falloff_k", "k", {0.05, 20.0, Scale::logarithmic}),
                    "k of the fall-off"))};
}

std::vector<Parameter> colors() {
    const std::string g = "Surface";
    const auto of_highlight = std::vector{phong, blinn, hall};
    return {by_material(color(g, "surface", "ka", "K_a", "ambient"),
                        [](const Material& m) { return color_value(m.ambient); }),
            by_material(color(g, "surface", "kd", "K_d", "diffuse"),
                        [](const Material& m) { return color_value(m.diffuse); }),
            of(by_material(color(g, "surface", "ks", "K_s", "specular"),
                           [](const Material& m) { return color_value(m.specular); }),
               of_highlight),
            of(by_material(named(slider(g, "surface", "n", "n", {1.0, 2000.0, Scale::logarithmic}),
                                 "exponent"),
                           [](const Material& m) { return number_value(m.exponent.value()); }),
               of_highlight)};
}

std::vector<Parameter> transmission() {
    const std::string g = "Surface";
    return {of(by_material(color(g, "surface", "kdt", "K_dt", "diffuse from behind"),
                           [](const Material& m) { return color_value(m.transmission.diffuse); }),
               {hall}),
            of(by_material(color(g, "surface", "kt", "K_t", "specular from behind"),
                           [](const Material& m) { return color_value(m.transmission.specular); }),
               {hall}),
            of(by_material(
                   named(slider(g, "surface", "nt", "n_t", {1.0, 2000.0, Scale::logarithmic}),
                         "exponent from behind"),
                   [](const Material& m) { return number_value(m.transmission.exponent.value()); }),
               {hall})};
}

/// Of one kind, so that the body's is said in one way.
void forget_metal(SceneOptions& options) {
    forget_reflectance(options.material.facets);
}

std::vector<Parameter> facets() {
    const std::string g = "Surface";
    const auto only = std::vector{cook_torrance};
    return {
        of(named(slider(g, "surface", "roughness", "m", {0.05, 1.0, Scale::logarithmic}),
                 "roughness"),
           only),
        of(or_unsaid(choice(g, "surface", "metal"), "none", forget_metal), only),
        where([](const SceneOptions& o) { return !o.material.facets.is_metal(); },
              of(by_material(
                     named(slider(g, "surface", "ior", "\xCE\xB7", {1.0, 3.0}), "refractive index"),
                     [](const Material& m) { return number_value(m.facets.reflectance.n.x); }),
                 {cook_torrance, hall})),
        of(by_material(slider(g, "surface", "specular_share", "K_s", {0.0, 1.0}),
                       [](const Material& m) { return number_value(m.facets.share); }),
           only),
        of(choice(g, "surface", "distribution"), only),
        of(choice(g, "surface", "constant"), only),
        of(choice(g, "surface", "fresnel"), only)};
}

std::vector<Parameter> transparency() {
    const std::string g = "Surface";
    Parameter t =
        by_material(named(slider(g, "surface", "opacity", "t", {0.0, 1.0}), "transparency"),
                    [](const Material& m) { return number_value(m.opacity); });
    t.turned = [](double x) { return 1.0 - x; };
    return {t,
            by_material(color(g, "surface", "mirror", "K_s'", "mirrored"),
                        [](const Material& m) { return color_value(m.mirror); }),
            by_material(color(g, "surface", "refract", "K_t'", "refracted"),
                        [](const Material& m) { return color_value(m.refracted); })};
}

std::vector<Parameter> polygons() {
    const std::string g = "Polygons";
    return {choice(g, "render", "interpolation"),
            choice(g, "render", "perspective"),
            choice(g, "render", "normals"),
            named(slider(g, "render", "crease_deg", "", {0.0, 180.0}), "crease angle"),
            choice(g, "render", "cull"),
            choice(g, "render", "sides"),
            or_unsaid(choice(g, "render", "wireframe"), "none",
                      [](SceneOptions& o) { o.wireframe_word.clear(); })};
}

bool has_shadow_maps(const SceneOptions& options) {
    return options.settings.shadows == render::Shadows::map;
}

/// A filter has a pixel in its middle.
Value odd(const Value& value) {
    return whole_value(static_cast<int>(number_of(value).value_or(1.0)) | 1);
}

std::vector<Parameter> shadows() {
    const std::string g = "Shadows";
    Parameter filter = whole_slider(g, "render", "shadow_pcf", {1, 15});
    filter.nearest = odd;
    return {choice(g, "render", "shadows"),
            check(g, "render", "floor"),
            choice(g, "render", "show"),
            where(has_shadow_maps,
                  whole_slider(g, "render", "shadow_map_size", {32, 4096, Scale::logarithmic})),
            where(has_shadow_maps, slider(g, "render", "shadow_bias", "", {0.0, 8.0})),
            where(has_shadow_maps, filter)};
}

/// Where the knob has a value.
Parameter where_said(const Parameter& p) {
    return where([knob = p.knob](const SceneOptions& o) { return knob.get(o).has_value(); }, p);
}

/// A number of a texture, where there is one.
Parameter texture_slider(const std::string& name, const std::string& symbol, const Knob& knob,
                         Range range) {
    Parameter p{"Textures", name, symbol, knob};
    p.control = Control::slider;
    p.low = range.low;
    p.high = range.high;
    p.scale = range.scale;
    return where_said(p);
}

bool has_marble(const SceneOptions& options) {
    return text_of(*pattern_knob(TextureSlot::diffuse).get(options)) == "marble";
}

/// Of what a slot's texture is made, and how it lies on the surface.
std::vector<Parameter> textures() {
    std::vector<Parameter> all;
    for (const TextureSlot slot : {TextureSlot::diffuse, TextureSlot::bump}) {
        Parameter pattern{"Textures", word_of(slot) + " texture", "", pattern_knob(slot)};
        pattern.words = words_in(pattern.knob);
        Parameter mapping{"Textures", word_of(slot) + " mapping", "", mapping_knob(slot)};
        mapping.words = words_in(mapping.knob);
        all.insert(all.end(),
                   {pattern, where_said(mapping),
                    texture_slider(word_of(slot) + " count", "", count_knob(slot), {1.0, 64.0})});
    }
    all.push_back(where(has_marble, texture_slider("marble's bend", "",
                                                   bend_knob(TextureSlot::diffuse), {0.0, 10.0})));
    all.push_back(
        texture_slider("height of the bumps", "F", height_knob(TextureSlot::bump), {-0.5, 0.5}));
    all.push_back(named(check("Textures", "render", "own_textures"), "the mesh's own"));
    return all;
}

std::vector<Parameter> camera() {
    const std::string g = "Camera";
    return {choice(g, "camera", "projection"),
            named(slider(g, "camera", "fov_deg", "", {1.0, 120.0}), "field of view"),
            slider(g, "camera", "zoom", "", {0.1, 10.0, Scale::logarithmic})};
}

std::vector<Parameter> surroundings() {
    const std::string g = "Surroundings";
    return {or_unsaid(named(choice(g, "environment", "built_in"), "environment"), "none",
                      [](SceneOptions& o) { o.environment = {}; }),
            where([](const SceneOptions& o) { return !o.environment.image.empty(); },
                  named(check(g, "environment", "light"), "lights all"))};
}

/// Whether a picture with this illumination model, of these shadows, has a use for the parameter.
bool knows(const Parameter& parameter, const SceneOptions& options) {
    const auto chosen = models_in(options);
    return parameter.models.empty() || std::ranges::any_of(chosen, [&](auto model) {
               return std::ranges::find(parameter.models, model) != parameter.models.end();
           });
}

/// A parameter of a light is one of those that are said.
SceneOptions with_said_lights(SceneOptions options, const Parameter& parameter) {
    if (parameter.light) options.lights = lights_in(options);
    return options;
}

/// The nearest colour of bytes: command lines name those of lights so.
Value in_bytes(const Value& value) {
    const auto color = color_of(value);
    if (!color) return value;
    glm::vec3 nearest;
    for (int k = 0; k < 3; ++k)
        nearest[k] = raster::linear_from_srgb(raster::srgb_from_linear((*color)[k]));
    return color_value(nearest);
}

}  // namespace

std::vector<Parameter> parameters() {
    std::vector<Parameter> all;
    for (const auto& group : {light_models(), colors(), transmission(), facets(), transparency(),
                              polygons(), shadows(), textures(), camera(), surroundings()})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

std::vector<Parameter> light_parameters(std::size_t light) {
    const std::string name = "light " + std::to_string(light + 1);
    const std::string symbol = "I_p" + std::to_string(light + 1);
    std::vector<Parameter> all;
    for (const char* key : {"color", "falloff"}) {
        Parameter p{"Lights", name + " " + key, "", knob("light", key, light)};
        p.words = words_in(p.knob);
        p.light = light;
        all.push_back(std::move(p));
    }
    all[0].control = Control::color;
    all[0].symbol = symbol;
    all[0].name = name;
    all[0].nearest = in_bytes;
    // A light at infinity has no fall-off.
    all[1].wanted = [light](const SceneOptions& options) {
        return lights_in(options).at(light).frame == LightFrame::point;
    };
    return all;
}

bool applies(const Parameter& parameter, const SceneOptions& options) {
    return knows(parameter, options) && (!parameter.wanted || parameter.wanted(options));
}

std::optional<Value> shown_value(const Parameter& parameter, const SceneOptions& options,
                                 const shading::Material<float>& material) {
    std::optional<Value> value = parameter.knob.get(with_said_lights(options, parameter));
    const bool is_word = value && text_of(*value) && parameter.control != Control::choice;
    if ((!value || (is_word && !color_of(*value))) && parameter.actual)
        value = parameter.actual(material);
    if (!value && parameter.clear) value = text_value(parameter.unsaid);
    if (!value || !parameter.turned) return value;
    const auto number = number_of(*value);
    return number ? std::optional(number_value(parameter.turned(*number))) : std::nullopt;
}

SceneOptions with_value(SceneOptions options, const Parameter& parameter, const Value& value) {
    options = with_said_lights(std::move(options), parameter);
    if (parameter.clear && text_of(value) == parameter.unsaid) {
        parameter.clear(options);
        return options;
    }
    const auto number = number_of(value);
    if (parameter.turned && number) {
        parameter.knob.set(options, number_value(parameter.turned(*number)));
    } else {
        parameter.knob.set(options, parameter.nearest ? parameter.nearest(value) : value);
    }
    return options;
}

}  // namespace scanlight::apps::window
