#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/scene/document.h"
#include "apps/scene/json.h"
#include "apps/scene/scene_options.h"
#include "apps/scene/words.h"

namespace scanlight::apps {

/// What the value of a key may be, for all who ask: the reader, the writer, the reference and the
/// schema.
template <class T>
struct Kind {
    /// "a number from 1 to 170": follows "expected".
    std::string words;
    Json schema;
    /// Nothing if the value is not of the kind. Paths are relative to the folder.
    std::function<std::optional<T>(const Value&, const std::filesystem::path& folder)> read;
    /// As TOML.
    std::function<std::string(const T&, const std::filesystem::path& folder)> write;
};

Kind<double> number(double low, double high);
Kind<float> float_number(double low, double high);
Kind<bool> boolean();
Kind<std::string> text();  // one line of 1 to 200 bytes
Kind<std::string> one_of(const std::vector<std::string>& words);
Kind<int> samples();  // 1, 4 or 16 a pixel; how many each way
Kind<int> whole_number(int low, int high);
Kind<int> odd_number(int most);
Kind<raster::Viewport> picture_size();
Kind<render::ViewAngles> view_angles();
Kind<glm::dvec3> point();      // three numbers
Kind<glm::dvec3> direction();  // not all of them 0
Kind<glm::dvec3> factors();    // one for all axes, or three
Kind<glm::vec2> repeats();     // one for u and v, or two
Kind<glm::vec3> color();
Kind<std::optional<glm::vec3>> color_or_none();
Kind<std::string> mesh_path();
Kind<std::string> image_path();
Kind<std::string> shape_name();
Kind<std::vector<Turn>> turns();
Kind<glm::dmat4> matrix();

/// The words of a choice.
template <class Choice>
Kind<Choice> word() {
    std::vector<std::string> names;
    for (const auto& [name, value] : words_beside(Choice{}))
        names.push_back(name);
    const Kind<std::string> words = one_of(names);
    const auto read = [words](const Value& value,
                              const std::filesystem::path& folder) -> std::optional<Choice> {
        const auto text = words.read(value, folder);
        for (const auto& [name, choice] : words_beside(Choice{})) {
            if (text == name) return choice;
        }
        return std::nullopt;
    };
    const auto write = [words](const Choice& choice, const std::filesystem::path& folder) {
        return words.write(word_of(choice), folder);
    };
    return {words.words, words.schema, read, write};
}

}  // namespace scanlight::apps
