#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace scanlight::apps {

using Json = nlohmann::ordered_json;

/// A float as the shortest decimal number that is read back as this float: 0.7875 and not
/// 0.7875000238418579, which is the same float told as a double.
Json json_number(float value);

/// The document, indented, and a line's end. Names of files and of materials need not be UTF-8:
/// what is not is replaced.
std::string json_text(const Json& json);

}  // namespace scanlight::apps
