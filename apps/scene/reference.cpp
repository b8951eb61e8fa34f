#include "apps/scene/reference.h"

#include "apps/scene/json.h"
#include "apps/scene/keys.h"

namespace scanlight::apps {

namespace {

const std::string introduction = R"(# Scene files

A scene file says in [TOML](https://toml.io/en/v1.0.0) what a picture shows: meshes with their places and
surfaces, lights, a camera, and how it is drawn. `scanlight render scene.toml` draws it; so does
`scene:PATH` whatever the file's ending, and `scene:-` for standard input. Options on the command line
come over what the file says, for all objects; `--light` replaces all its lights.
`scanlight render … --save-scene scene.toml` writes the scene that draws the same picture.

This page is what `scanlight scene --reference` prints; `scanlight scene --schema` prints a JSON Schema, for
editors.

```toml
[camera]
view = [25, 35]

[render]
size = [640, 480]
shadows = "zfail"
floor = true

[[light]]
position = [-3, 5, 3]
color = "#ffe0c0"

[[material]]
name = "gold"
kd = [0.5, 0.3, 0.05]
ks = 0.6
n = 30

[[object]]
shape = "teapot:8"
material = "gold"
rotate = { axis = [0, 1, 0], deg = 30 }

[[texture]]
name = "veins"
pattern = "marble"
low = "#20242c"

[[object]]
mesh = "bunny.obj"
translate = [2, 0, 0]
diffuse_texture = "veins"
```

What is said of a surface comes over its mesh's own materials in this order: the `[[material]]` that the object
names, the object's own textures, `[surface]`, the command line.

Lengths are in world units, angles in degrees, y is up. Numbers are finite. Unknown keys are refused.

## `include`

`include = ["lights.toml", "../meshes/table.toml"]`, before the first table: other scene files, from this
file's folder. They are read first: what this file says comes over it, and its lights, textures, materials and
objects join theirs. At most 16 files deep and 256 in all.
)";

std::string row(const KeyInfo& key) {
    const std::string fallback = key.fallback.empty() ? "" : key.fallback;
    return "| `" + key.name + "` | " + key.words + " | " + fallback + " | " + key.meaning + " |\n";
}

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "`" : " or `") + name + "`";
    return list;
}

std::string rules_text(const KeyRules& rules) {
    std::string text;
    for (const auto& names : rules.one_of)
        text += "Needs " + joined(names) + ".\n";
    for (const auto& [a, b] : rules.never_both)
        text += "Never `" + a + "` with `" + b + "`.\n";
    for (const auto& [a, b] : rules.needs)
        text += "`" + a + "` needs `" + b + "`.\n";
    return text.empty() ? "" : "\n" + text;
}

std::string section_text(const Section& section) {
    std::string text = "\n## `" + section.heading() + "`\n\n" + section.meaning;
    if (section.is_repeated()) text += " At most " + std::to_string(section.most) + ".";
    text += "\n\n| key | value | if not given | |\n|---|---|---|---|\n";
    for (const KeyInfo& key : section.keys)
        text += row(key);
    return text + rules_text(section.rules);
}

// ---- schema

Json required(const std::string& name) {
    return {{"required", {name}}};
}

Json rules_json(const KeyRules& rules) {
    Json all = Json::array();
    for (const auto& names : rules.one_of) {
        Json any = Json::array();
        for (const std::string& name : names)
            any.push_back(required(name));
        all.push_back({{"anyOf", any}});
    }
    for (const auto& [a, b] : rules.never_both)
        all.push_back({{"not", {{"required", {a, b}}}}});
    return all;
}

Json table_schema(const Section& section) {
    Json properties = Json::object();
    for (const KeyInfo& key : section.keys) {
        properties[key.name] = key.schema;
        properties[key.name]["description"] = key.meaning;
    }
    Json schema{{"type", "object"},
                {"description", section.meaning},
                {"properties", properties},
                {"additionalProperties", false}};
    const Json all = rules_json(section.rules);
    if (!all.empty()) schema["allOf"] = all;
    for (const auto& [a, b] : section.rules.needs)
        schema["dependentRequired"][a].push_back(b);
    return schema;
}

Json section_schema(const Section& section) {
    if (!section.is_repeated()) return table_schema(section);
    return {{"type", "array"}, {"maxItems", section.most}, {"items", table_schema(section)}};
}

}  // namespace

std::string scene_reference() {
    std::string text = introduction;
    for (const Section& section : sections())
        text += section_text(section);
    return text;
}

std::string scene_schema() {
    Json properties{
        {"include", {{"type", "array"}, {"items", {{"type", "string"}, {"minLength", 1}}}}}};
    for (const Section& section : sections()) {
        const std::size_t dot = section.name.find('.');
        Json& place = dot == std::string::npos
                          ? properties[section.name]
                          : properties[section.name.substr(0, dot)]["properties"]
                                      [section.name.substr(dot + 1)];
        place = section_schema(section);
    }
    return json_text({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "Scanlight scene"},
                      {"type", "object"},
                      {"properties", properties},
                      {"additionalProperties", false}});
}

}  // namespace scanlight::apps
