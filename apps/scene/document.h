#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "mesh/file_error.h"

namespace scanlight::apps {

/// A place in a text file, from 1.
struct Place {
    int line = 1;
    int column = 1;
};

/// A value as a TOML file has it, without the parser.
struct Value;
struct Entry;
using Array = std::vector<Value>;
using Table = std::vector<Entry>;  // in the order of the names, each once
/// A date or a time: nothing that a scene knows.
struct Moment {};

struct Value {
    Place place;
    std::variant<bool, std::int64_t, double, std::string, Moment, Array, Table> is;
};
struct Entry {
    std::string name;
    Place place;  // of the name
    Value value;
};

/// No larger scene file is read.
inline constexpr std::size_t max_document_bytes = std::size_t{1} << 20;

/// The tables of a TOML 1.0 text. Throws FileError "name:line:column: reason" for anything else,
/// for what is too large, and for what is nested deeper than any scene: whatever the text, it takes
/// little stack, and memory of no more than a few hundred times its size.
Table parse_document(std::string_view text, const std::string& name);

/// "name:line:column"
std::string place_text(const std::string& name, const Place& place);

/// 'red', with a ? for each byte that cannot be shown.
std::string in_quotes(std::string_view text);

/// What a value is, for a message: "200", "'red'", "a table".
std::string described(const Value& value);

/// The entry of a name, or null.
const Entry* find(const Table& table, std::string_view name);

}  // namespace scanlight::apps
