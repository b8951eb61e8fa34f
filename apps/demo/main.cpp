#include <algorithm>
#include <iterator>
#include <string_view>

#include "apps/demo/program.h"
#include "apps/demo/window_program.h"

namespace {

/// What the course alone knows, and what is asked of any program.
constexpr std::string_view course_words[] = {"--list", "--lesson", "--export",
                                             "--help", "-h",       "--version"};

[[maybe_unused]] bool is_of_the_course(std::string_view word) {
    return std::ranges::find(course_words, word.substr(0, word.find('='))) !=
           std::end(course_words);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace scanlight::demo;
    if constexpr (has_window) {
        const bool wants_window =
            std::find(argv + 1, argv + argc, std::string_view("--window")) != argv + argc;
        const bool wants_course =
            !wants_window && std::any_of(argv + 1, argv + argc, is_of_the_course);
        if (!wants_course) return run_window_program(argc, argv);
    }
    return run(argc, argv);
}
