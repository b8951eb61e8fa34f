#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/scanlight/usage_error.h"
#include "apps/scanlight/words.h"

namespace scanlight::apps {

/// An option with a fixed set of words; `value` is filled as the command line is parsed.
template <class Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& value,
                        const std::string& help) {
    const Words<Choice> words = words_beside(value);
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
        ->default_str(word_of(value));
}

}  // namespace scanlight::apps
