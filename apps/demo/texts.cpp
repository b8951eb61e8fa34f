#include "apps/demo/texts.h"

#include <stdexcept>
#include <variant>

#include "apps/demo/embedded.h"
#include "apps/scene/document.h"
#include "apps/scene/usage_error.h"

namespace scanlight::demo {

namespace {

const std::string& text_of(const apps::Entry& entry) {
    if (const auto* text = std::get_if<std::string>(&entry.value.is)) return *text;
    throw mesh::FileError("texts.toml: " + entry.name + " is no text");
}

const apps::Table& table_of(const apps::Entry& entry) {
    if (const auto* table = std::get_if<apps::Table>(&entry.value.is)) return *table;
    throw mesh::FileError("texts.toml: " + entry.name + " is no table");
}

Texts::Words words_of(const apps::Table& table) {
    Texts::Words words;
    for (const apps::Entry& entry : table)
        words[entry.name] = text_of(entry);
    return words;
}

Texts::Chapter chapter_of(const apps::Table& table) {
    Texts::Chapter chapter;
    for (const apps::Entry& entry : table) {
        if (entry.name == "formula") chapter.formula = text_of(entry);
        if (entry.name == "en") chapter.english = words_of(table_of(entry));
        if (entry.name == "zh") chapter.chinese = words_of(table_of(entry));
    }
    return chapter;
}

}  // namespace

Language parse_language(const std::string& word) {
    if (word == "en") return Language::english;
    if (word == "zh") return Language::chinese;
    throw apps::UsageError("language '" + word + "': expected en or zh");
}

Texts::Texts(const std::string& toml) {
    for (const apps::Entry& entry : apps::parse_document(toml, "texts.toml"))
        chapters_[entry.name] = chapter_of(table_of(entry));
}

const std::string* Texts::find(const std::string& lesson, const std::string& key,
                               Language language) const {
    for (const std::string& name : {lesson, std::string("common")}) {
        const auto chapter = chapters_.find(name);
        if (chapter == chapters_.end()) continue;
        const Words& words =
            language == Language::english ? chapter->second.english : chapter->second.chinese;
        const auto found = words.find(key);
        if (found != words.end()) return &found->second;
    }
    return nullptr;
}

const std::string& Texts::of(const std::string& lesson, const std::string& key,
                             Language language) const {
    if (const std::string* text = find(lesson, key, language)) return *text;
    throw std::out_of_range(lesson + ": no text '" + key + "'");
}

std::string Texts::filled(const std::string& text, const std::string& lesson,
                          Language language) const {
    const std::size_t begin = text.find("{{");
    const std::size_t end = text.find("}}", begin);
    if (begin == std::string::npos || end == std::string::npos) return text;
    return text.substr(0, begin) + of(lesson, text.substr(begin + 2, end - begin - 2), language) +
           filled(text.substr(end + 2), lesson, language);
}

const Texts& texts() {
    static const Texts all{std::string(embedded::texts)};
    return all;
}

}  // namespace scanlight::demo
