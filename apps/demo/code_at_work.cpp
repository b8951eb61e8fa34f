#include "apps/demo/code_at_work.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "apps/demo/embedded.h"

namespace scanlight::demo {

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

bool is_found(const std::string& line, const std::string& words) {
    return line.find(words) != std::string::npos;
}

std::string indentation(const std::string& line) {
    return line.substr(0, line.find_first_not_of(' '));
}

/// From the line with these words to the brace that closes it, as far to the left as that allows.
Lines function_with(const std::string& words, const Lines& lines) {
    const auto begin =
        std::ranges::find_if(lines, [&](const auto& line) { return is_found(line, words); });
    if (begin == lines.end()) throw std::logic_error("no such function: " + words);
    const std::string indent = indentation(*begin);
    const auto end = std::find(begin, lines.end(), indent + "}");
    Lines function(begin, end == lines.end() ? end : end + 1);
    for (std::string& line : function)
        line.erase(0, std::min(indent.size(), line.size()));
    return function;
}

Excerpt excerpt(const std::string& file, std::string_view text, const std::string& function,
                const std::vector<std::string>& at_work) {
    Excerpt result{file, function_with(function, lines_of(text)), {}};
    for (const std::string& words : at_work) {
        const auto found = std::ranges::find_if(
            result.lines, [&](const auto& line) { return is_found(line, words); });
        if (found == result.lines.end()) throw std::logic_error("no such line: " + words);
        result.at_work.push_back(static_cast<std::size_t>(found - result.lines.begin()));
    }
    return result;
}

}  // namespace

Excerpt code_at_work(WalkStep::Kind kind) {
    switch (kind) {
        case WalkStep::Kind::edge:
            return excerpt("raster/fill.h", embedded::fill, "void walk(", {"table.build("});
        case WalkStep::Kind::scanline:
            return excerpt(
                "raster/scan_convert.h", embedded::scan_convert, "void scan_convert(",
                {"active.admit(", "active.sort_by_x(", "active.retire_before(", "active.step("});
        case WalkStep::Kind::pixel:
            break;
    }
    return excerpt("raster/fragments.h", embedded::fragments, "std::size_t draw_span(",
                   {"span.ramps.step()", "target_row[column] ="});
}

}  // namespace scanlight::demo
