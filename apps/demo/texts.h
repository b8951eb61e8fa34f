#pragma once

#include <map>
#include <string>

namespace scanlight::demo {

enum class Language { english, chinese };

/// "en" or "zh". Throws UsageError for another.
Language parse_language(const std::string& word);

/// All words of the course, from the one table of them, texts.toml.
class Texts {
public:
    using Words = std::map<std::string, std::string>;
    struct Chapter {
        std::string formula;  // MathML
        Words english, chinese;
    };

    /// Throws FileError for a table that is not in order.
    explicit Texts(const std::string& toml);

    /// What a lesson calls `key`, else what all lessons do; null if neither does.
    const std::string* find(const std::string& lesson, const std::string& key,
                            Language language) const;

    /// What a lesson calls `key`, else what all lessons do. Throws std::out_of_range if neither
    /// does.
    const std::string& of(const std::string& lesson, const std::string& key,
                          Language language) const;

    /// A text with each {{key}} in it replaced by what the key names.
    std::string filled(const std::string& text, const std::string& lesson, Language language) const;

    /// By the lessons' names; "common" and "page" among them.
    const std::map<std::string, Chapter>& chapters() const { return chapters_; }

private:
    std::map<std::string, Chapter> chapters_;
};

/// Those that the program brings along.
const Texts& texts();

}  // namespace scanlight::demo
