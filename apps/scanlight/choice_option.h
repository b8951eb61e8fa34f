#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/scene/usage_error.h"
#include "apps/scene/words.h"

namespace scanlight::apps {

/// An option with a fixed set of words; `value`, a choice or an optional one, is filled as the
/// command line is parsed. `fallback` holds where it is not given.
template <class Choice, class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& value, Choice fallback,
                        const std::string& help) {
    const Words<Choice> words = words_beside(fallback);
    std::string list;
    for (const auto& [word, meaning] : words)
        list += (list.empty() ? "" : "|") + word;
    const auto choose = [&value, words, name, list](const std::string& text) {
        for (const auto& [word, meaning] : words) {
            if (text != word) continue;
            value = meaning;
            return;
        }
        throw UsageError(name + " '" + text + "': expected " + list);
    };
    return app.add_option_function<std::string>(name, choose, help)
        ->type_name(list)
        ->default_str(word_of(fallback));
}

/// The same, with what `value` is before.
template <class Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& value,
                        const std::string& help) {
    return add_choice(app, name, value, value, help);
}

}  // namespace scanlight::apps
