#include "apps/scene/keys.h"

#include "apps/scene/object_keys.h"
#include "apps/scene/picture_keys.h"

namespace scanlight::apps {

namespace {

constexpr std::size_t most_camera_keys = 1000;
constexpr std::size_t most_lights = 1000;
constexpr std::size_t most_objects = 10000;
constexpr std::size_t most_materials = 10000;
constexpr std::size_t most_textures = 10000;

template <class Owner>
std::vector<KeyInfo> infos_of(const KeyTable<Owner>& table) {
    std::vector<KeyInfo> infos;
    for (const Key<Owner>& key : table.keys)
        infos.push_back(key.info);
    return infos;
}

/// A table of which there is one, for a part of the options.
template <class Owner, class Access>
Section one(const std::string& name, const std::string& meaning, const KeyTable<Owner>& table,
            Access access) {
    const auto read = [=](const Table& values, const Where& where, SceneOptions& options) {
        read_keys(table, values, where, access(options));
    };
    const auto write = [=](const SceneOptions& options, const std::filesystem::path& folder) {
        const std::string lines = write_keys(table, access(options), folder);
        return lines.empty() ? std::vector<std::string>{} : std::vector{lines};
    };
    return {name, meaning, 1, infos_of(table), table.rules, read, write};
}

/// A table of which there may be many, each one more of a list of the options.
template <class Owner>
Section many(const std::string& name, const std::string& meaning, std::size_t most,
             const KeyTable<Owner>& table, std::vector<Owner> SceneOptions::*list) {
    const auto read = [=](const Table& values, const Where& where, SceneOptions& options) {
        if ((options.*list).size() >= most)
            refuse_at(where.file, where.place,
                      "more than " + std::to_string(most) + " of " + where.table);
        read_keys(table, values, where, (options.*list).emplace_back());
    };
    const auto write = [=](const SceneOptions& options, const std::filesystem::path& folder) {
        std::vector<std::string> tables;
        for (const Owner& owner : options.*list)
            tables.push_back(write_keys(table, owner, folder));
        return tables;
    };
    return {name, meaning, most, infos_of(table), table.rules, read, write};
}

std::vector<Section> all_sections() {
    const auto all = [](auto& options) -> auto& {
        return options;
    };
    const auto material = [](auto& options) -> auto& {
        return options.material;
    };
    return {
        one("camera", "From where the picture is seen.", camera_keys(), all),
        many("camera.key",
             "Where the camera is at a moment of `scanlight turntable`, which goes smoothly from "
             "one "
             "to the next. All have `view`, or all `eye`.",
             most_camera_keys, camera_key_keys(), &SceneOptions::camera_keys),
        one("render", "How the picture is drawn.", render_keys(), all),
        one("surface", "What all objects are made of, whatever their own materials say.",
            surface_keys(), material),
        many("light", "A light. Without any there is one from the upper left.", most_lights,
             light_keys(), &SceneOptions::lights),
        one(
            "environment", "The light from far away, all around.", environment_keys(),
            [](auto& options) -> auto& { return options.environment; }),
        many("texture", "What changes over a surface, for materials and objects to name.",
             most_textures, texture_keys(), &SceneOptions::textures),
        many("material", "A surface, for objects to name.", most_materials, material_keys(),
             &SceneOptions::materials),
        many("object", "A mesh in the world.", most_objects, object_keys(), &SceneOptions::objects),
    };
}

}  // namespace

const std::vector<Section>& sections() {
    static const std::vector<Section> all = all_sections();
    return all;
}

}  // namespace scanlight::apps
