#include "apps/scene/document.h"

#include <algorithm>

#include "apps/scene/toml_number.h"
#include "mesh/text.h"

#define TOML_HEADER_ONLY       1
#define TOML_EXCEPTIONS        1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 16  // deeper is no scene, and each level takes stack
// toml++ 3.3 asserts, and where nothing is asserted lets clang assume, what it only then makes sure
// of: a "[" at the end of a line is enough. Here it does neither, and reports an error.
#undef NDEBUG
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>

namespace scanlight::apps {

namespace {

/// Dotted keys nest without the parser's limit, and all of their levels lie in one line.
constexpr std::ptrdiff_t most_dots_a_line = 100;

Place place_of(const toml::source_position& position) {
    return {static_cast<int>(position.line), static_cast<int>(position.column)};
}

Value value_of(const toml::node& node);

Array array_of(const toml::array& nodes) {
    Array array;
    for (const toml::node& node : nodes)
        array.push_back(value_of(node));
    return array;
}

Table table_of(const toml::table& nodes) {
    Table table;
    for (const auto& [key, node] : nodes)
        table.push_back({std::string(key.str()), place_of(key.source().begin), value_of(node)});
    return table;
}

Value value_of(const toml::node& node) {
    Value value{place_of(node.source().begin), Moment{}};
    if (const auto* flag = node.as_boolean()) value.is = flag->get();
    if (const auto* integer = node.as_integer()) value.is = integer->get();
    if (const auto* number = node.as_floating_point()) value.is = number->get();
    if (const auto* text = node.as_string()) value.is = text->get();
    if (const auto* array = node.as_array()) value.is = array_of(*array);
    if (const auto* table = node.as_table()) value.is = table_of(*table);
    return value;
}

[[noreturn]] void refuse(const std::string& name, Place place, std::string_view reason) {
    throw mesh::FileError(place_text(name, place) + ": " + std::string(reason));
}

bool is_comment(std::string_view line) {
    return mesh::trimmed(line).starts_with('#');
}

void expect_shallow(std::string_view text, const std::string& name) {
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        if (std::ranges::count(line, '.') > most_dots_a_line && !is_comment(line))
            refuse(name, {number, 1},
                   "more than " + std::to_string(most_dots_a_line) + " dots in a line");
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

/// The parser's reason, in one line.
std::string in_one_line(std::string_view reason) {
    std::string line(reason.substr(0, 200));
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return line;
}

}  // namespace

std::string place_text(const std::string& name, const Place& place) {
    return name + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

Table parse_document(std::string_view text, const std::string& name) {
    if (text.size() > max_document_bytes) {
        throw mesh::FileError(name + ": a scene file larger than " +
                              std::to_string(max_document_bytes >> 20) + " MiB");
    }
    expect_shallow(text, name);
    try {
        return table_of(toml::parse(text));
    } catch (const toml::parse_error& error) {
        refuse(name, place_of(error.source().begin), in_one_line(error.description()));
    }
}

std::string in_quotes(std::string_view text) {
    return "'" + mesh::printable(text) + "'";
}

std::string described(const Value& value) {
    if (const auto* flag = std::get_if<bool>(&value.is)) return *flag ? "true" : "false";
    if (const auto* integer = std::get_if<std::int64_t>(&value.is)) return std::to_string(*integer);
    if (const auto* number = std::get_if<double>(&value.is)) return toml_number(*number);
    if (const auto* text = std::get_if<std::string>(&value.is)) return in_quotes(*text);
    if (std::holds_alternative<Table>(value.is)) return "a table";
    if (std::holds_alternative<Moment>(value.is)) return "a date or time";
    return "an array of " + mesh::counted(std::get<Array>(value.is).size(), "value", "values");
}

const Entry* find(const Table& table, std::string_view name) {
    const auto found = std::ranges::find(table, name, &Entry::name);
    return found == table.end() ? nullptr : &*found;
}

}  // namespace scanlight::apps
