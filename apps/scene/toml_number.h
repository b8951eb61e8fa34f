#pragma once

#include <string>

namespace scanlight::apps {

/// The shortest TOML number that is read back as this one: "0.1", "30", "1e+20", "nan".
std::string toml_number(double number);

/// The same of a float: "0.1" and not "0.10000000149011612".
std::string toml_number(float number);

/// In quotes, with what TOML wants escaped.
std::string toml_string(const std::string& text);

}  // namespace scanlight::apps
