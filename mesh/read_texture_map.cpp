#include "mesh/read_texture_map.h"

#include <charconv>
#include <string>
#include <system_error>

#include "mesh/mtl_words.h"

namespace scanlight::mesh {
namespace {

bool is_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double ignored;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, ignored);
    return stop == end && error != std::errc::invalid_argument;
}

class MapReader {
public:
    MapReader(std::string_view statement, Cursor& text, Warnings& warnings)
        : statement_(statement), text_(text), warnings_(warnings) {}

    std::optional<MapArguments> read() {
        while (option_follows()) {
            const std::string_view option = text_.word();
            if (read_option(option)) continue;
            warn(std::string(statement_) + " has an unknown option " + quoted(option) +
                 ": it is passed over");
            return std::nullopt;
        }
        if (text_.at_line_end()) {
            warn(std::string(statement_) + " names no file: it is passed over");
            return std::nullopt;
        }
        result_.map.path = text_.rest_of_line();
        return result_;
    }

private:
    /// A last word that begins like an option, but is none, is a file's name.
    bool option_follows() {
        if (text_.at_line_end()) return false;
        const std::size_t start = text_.offset();
        const std::string_view word = text_.word();
        const bool is_last = text_.at_line_end();
        text_.seek(start);
        return word.starts_with('-') && (!is_last || is_option(word));
    }

    static bool is_option(std::string_view word) {
        for (const std::string_view option :
             {"-s", "-o", "-t", "-mm", "-bm", "-clamp", "-blendu", "-blendv", "-imfchan", "-type",
              "-texres", "-boost", "-cc"}) {
            if (word == option) return true;
        }
        return false;
    }

    /// False for a word that is no option.
    bool read_option(std::string_view word) {
        TextureMap& map = result_.map;
        if (word == "-s") {
            map.scale = triple(1.0f);
        } else if (word == "-o") {
            map.offset = triple(0.0f);
        } else if (word == "-mm") {
            map.base = text_.single();
            map.gain = text_.single();
        } else if (word == "-bm") {
            map.bump = text_.single();
        } else if (word == "-clamp") {
            map.clamped = is_on();
        } else if (word == "-blendu") {
            map.blended_u = is_on();
        } else if (word == "-blendv") {
            map.blended_v = is_on();
        } else if (word == "-imfchan") {
            map.channel = named(channel_letters, "r, g, b, m, l or z");
        } else if (word == "-type") {
            result_.reflection = named(reflection_types, "sphere or a side such as cube_top");
        } else {
            return read_ignored_option(word);
        }
        return true;
    }

    bool read_ignored_option(std::string_view word) {
        if (!is_option(word)) return false;
        warn(std::string(word) + " of " + std::string(statement_) + " is passed over");
        if (word == "-t") {
            triple(0.0f);
        } else if (word == "-cc") {
            is_on();
        } else {
            text_.single();
        }
        return true;
    }

    void warn(const std::string& sentence) { warnings_.add(text_.offset(), sentence); }

    /// One to three numbers.
    glm::vec3 triple(float fill) {
        glm::vec3 result(text_.single(), fill, fill);
        for (int k = 1; k < 3 && number_follows(); ++k)
            result[k] = text_.single();
        return result;
    }

    bool number_follows() {
        if (text_.at_line_end()) return false;
        const std::size_t start = text_.offset();
        const bool found = is_number(text_.word()) && !text_.at_line_end();
        text_.seek(start);
        return found;
    }

    bool is_on() {
        const std::string_view word = text_.word();
        if (word == "on" || word == "off") return word == "on";
        text_.fail(quoted(word) + " is neither on nor off");
    }

    template <class Value, std::size_t n>
    Value named(const std::pair<std::string_view, Value> (&words)[n], const char* expected) {
        const std::string_view word = text_.word();
        for (const auto& [name, value] : words) {
            if (word == name) return value;
        }
        text_.fail(quoted(word) + " is not " + expected);
    }

    std::string_view statement_;
    Cursor& text_;
    Warnings& warnings_;
    MapArguments result_;
};

}  // namespace

std::optional<MapArguments> read_texture_map(std::string_view statement, Cursor& text,
                                             Warnings& warnings) {
    return MapReader(statement, text, warnings).read();
}

}  // namespace scanlight::mesh
