#include "apps/scene/read_scene.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "apps/scene/keys.h"
#include "mesh/input.h"
#include "mesh/text.h"

namespace scanlight::apps {

namespace {

constexpr std::string_view scene_prefix = "scene:";
constexpr std::string_view scene_ending = ".toml";
constexpr std::string_view include_key = "include";
constexpr std::size_t most_nested = 16;  // files that include one another
constexpr std::size_t most_includes =
    256;  // in all: a few files could name each other over and over

/// Tables within tables, such as [[camera.key]], beside them, by their whole names.
Table with_dotted_names(Table document) {
    for (const Section& section : sections()) {
        const std::size_t dot = section.name.find('.');
        const auto outer = std::ranges::find(document, section.name.substr(0, dot), &Entry::name);
        if (dot == std::string::npos || outer == document.end()) continue;
        auto* table = std::get_if<Table>(&outer->value.is);
        if (table == nullptr) continue;
        const auto inner = std::ranges::find(*table, section.name.substr(dot + 1), &Entry::name);
        if (inner == table->end()) continue;
        Entry moved = std::move(*inner);
        moved.name = section.name;
        table->erase(inner);
        document.push_back(std::move(moved));
    }
    return document;
}

/// Reads a scene file and those it includes.
class SceneReader {
public:
    explicit SceneReader(SceneOptions& options) : options_(options) {}

    /// The file that is read first, so that no other includes it.
    void open(const std::string& path) {
        open_.push_back(std::filesystem::weakly_canonical(path).string());
    }

    void read(std::string_view text, const std::string& name, const std::string& folder) {
        const Table document = with_dotted_names(parse_document(text, name));
        check_names(document, name);
        if (const Entry* entry = find(document, include_key)) include(entry->value, name, folder);
        for (const Section& section : sections()) {
            if (const Entry* entry = find(document, section.name))
                read_section(section, entry->value, name, folder);
        }
    }

private:
    static void check_names(const Table& document, const std::string& name) {
        std::vector<std::string> known{std::string(include_key)};
        for (const Section& section : sections())
            known.push_back(section.name);
        check_keys(document, known, {}, {name, "", "a scene file", {}});
    }

    void read_section(const Section& section, const Value& value, const std::string& name,
                      const std::string& folder) {
        for (const Value* table : tables_in(section, value, name)) {
            section.read(std::get<Table>(table->is),
                         {name, folder, section.heading(), table->place}, options_);
        }
    }

    static std::vector<const Value*> tables_in(const Section& section, const Value& value,
                                               const std::string& name) {
        std::vector<const Value*> values;
        const auto* array = std::get_if<Array>(&value.is);
        if (!section.is_repeated()) {
            values.push_back(&value);
        } else if (array != nullptr) {
            for (const Value& item : *array)
                values.push_back(&item);
        }
        const auto is_table = [](const Value* v) { return std::holds_alternative<Table>(v->is); };
        if ((array == nullptr && section.is_repeated()) || !std::ranges::all_of(values, is_table))
            refuse_at(name, value.place,
                      "'" + section.name + "': expected " +
                          (section.is_repeated() ? "tables " : "a table ") + section.heading() +
                          ", not " + described(value));
        return values;
    }

    // ---- other files

    void include(const Value& value, const std::string& name, const std::string& folder) {
        const auto* paths = std::get_if<Array>(&value.is);
        if (paths == nullptr) refuse_include(value, name);
        for (const Value& path : *paths) {
            const auto* text = std::get_if<std::string>(&path.is);
            if (text == nullptr || text->empty() || text->find('\0') != std::string::npos)
                refuse_include(path, name);
            include_file(std::filesystem::path(folder) / *text, path.place, name);
        }
    }

    [[noreturn]] static void refuse_include(const Value& value, const std::string& name) {
        refuse_at(name, value.place,
                  "'include': expected an array of paths of scene files, not " + described(value));
    }

    void include_file(const std::filesystem::path& path, const Place& place,
                      const std::string& from) {
        const std::string whole = std::filesystem::weakly_canonical(path).string();
        if (std::ranges::find(open_, whole) != open_.end())
            refuse_at(from, place, path.generic_string() + " includes itself");
        if (open_.size() >= most_nested)
            refuse_at(from, place,
                      "includes are nested more than " + std::to_string(most_nested) + " deep");
        if (++included_ > most_includes)
            refuse_at(from, place, "more than " + std::to_string(most_includes) + " includes");
        open_.push_back(whole);
        read(contents(path, place, from).view(), path.generic_string(),
             path.parent_path().generic_string());
        open_.pop_back();
    }

    static mesh::Bytes contents(const std::filesystem::path& path, const Place& place,
                                const std::string& from) {
        try {
            return mesh::read_regular_file(path.generic_string());
        } catch (const mesh::FileError& error) {
            refuse_at(from, place, std::string("'include': ") + error.what());
        }
    }

    SceneOptions& options_;
    std::vector<std::string> open_;  // files whose reading has begun and not ended
    std::size_t included_ = 0;
};

/// Things that others name: materials, textures.
class Names {
public:
    /// Throws unless each has a name of its own; `kind` is "material".
    template <class Named>
    Names(std::string kind, const std::vector<Named>& list) : kind_(std::move(kind)) {
        for (const Named& one : list) {
            if (!known_.insert(one.name).second)
                throw mesh::FileError(one.stated.at({"name"}) + ": a second " + kind_ + " named " +
                                      in_quotes(one.name));
        }
    }

    /// Throws unless the name is empty or that of one of them.
    void expect(const std::string& name, const std::string& stated_at) const {
        if (name.empty() || known_.contains(name)) return;
        throw mesh::FileError(stated_at + ": no " + kind_ + " is named " + in_quotes(name) +
                              suggestion(name, {known_.begin(), known_.end()}));
    }

private:
    std::string kind_;
    std::set<std::string> known_;
};

/// Throws unless what is named is there.
void check_names(const SceneOptions& options) {
    const Names materials("material", options.materials);
    const Names textures("texture", options.textures);
    const auto expect_textures = [&](const auto& owner) {
        for (const auto& [word, slot] : words_beside(TextureSlot{}))
            textures.expect(owner.textures[slot], owner.stated.at({word + "_texture"}));
    };
    expect_textures(options.material);
    std::ranges::for_each(options.materials, expect_textures);
    std::ranges::for_each(options.objects, expect_textures);
    for (const ObjectOptions& object : options.objects)
        materials.expect(object.material, object.stated.at({"material"}));
}

std::string scene_path(const std::string& input) {
    return input.starts_with(scene_prefix) ? input.substr(scene_prefix.size()) : input;
}

void read_scene_file(SceneOptions& options, const std::string& path) {
    SceneReader reader(options);
    if (path != "-") reader.open(path);
    const mesh::Bytes bytes = mesh::read_input(path);
    reader.read(bytes.view(), mesh::display_name(path),
                std::filesystem::path(path).parent_path().generic_string());
    check_names(options);
}

}  // namespace

bool names_scene(const std::string& input) {
    return input.starts_with(scene_prefix) || input.ends_with(scene_ending);
}

void set_input(SceneOptions& options, const std::string& input) {
    options.input = input;
    if (names_scene(input)) {
        read_scene_file(options, scene_path(input));
    } else {
        options.objects.emplace_back().input = input;
    }
}

void read_scene(SceneOptions& options, std::string_view text, const std::string& name,
                const std::string& folder) {
    SceneReader(options).read(text, name, folder);
    check_names(options);
}

}  // namespace scanlight::apps
