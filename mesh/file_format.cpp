#include "mesh/file_format.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/cursor.h"
#include "mesh/load_stl.h"

namespace scanlight::mesh {
namespace {

constexpr std::array<std::string_view, 10> obj_words{"v", "vt", "vn", "f",      "g",
                                                     "o", "s",  "vp", "mtllib", "usemtl"};

constexpr std::array<std::pair<std::string_view, FileFormat>, 4> endings{
    {{".obj", FileFormat::obj},
     {".ply", FileFormat::ply},
     {".off", FileFormat::off},
     {".stl", FileFormat::stl}}};

std::string_view first_word(std::string_view bytes) {
    Cursor text(bytes, "", {.hash_comments = true});
    text.skip_space();
    return text.word();
}

/// OFF with any prefix, and nothing but a count grown onto it: "STCNOFF", "OFF490".
bool is_off_keyword(std::string_view word) {
    const std::size_t keyword = word.find("OFF");
    if (keyword == word.npos) return false;
    const std::string_view prefix = word.substr(0, keyword);
    const std::string_view rest = word.substr(keyword + 3);
    return prefix.find_first_not_of("STCN4n") == prefix.npos &&
           rest.find_first_not_of("0123456789") == rest.npos;
}

std::optional<FileFormat> format_of_content(std::string_view bytes) {
    const std::string_view word = first_word(bytes);
    if (word == "ply") return FileFormat::ply;
    if (is_binary_stl(bytes) || equal_ignoring_case(word, "solid")) return FileFormat::stl;
    if (is_off_keyword(word)) return FileFormat::off;
    if (std::ranges::find(obj_words, word) != obj_words.end()) return FileFormat::obj;
    return std::nullopt;
}

std::optional<FileFormat> format_of_ending(std::string_view path) {
    for (const auto& [ending, format] : endings) {
        const std::size_t start = path.size() - std::min(path.size(), ending.size());
        if (equal_ignoring_case(path.substr(start), ending)) return format;
    }
    return std::nullopt;
}

}  // namespace

std::optional<FileFormat> format_of(std::string_view bytes, std::string_view path) {
    const std::optional<FileFormat> told = format_of_content(bytes);
    return told ? told : format_of_ending(path);
}

}  // namespace scanlight::mesh
