#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace scanlight::apps {

/// A number from `low` to `high`. CLI::Range would let NaN pass.
CLI::Validator within(double low, double high);

/// An option whose text `use` turns into a value.
template <class Use>
CLI::Option* add_text(CLI::App& app, const std::string& name, const std::string& type,
                      const std::string& help, Use use) {
    return app.add_option_function<std::string>(name, use, help)->type_name(type);
}

}  // namespace scanlight::apps
