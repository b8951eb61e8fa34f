#include "apps/exercises/exercise.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "raster/compare.h"
#include "raster/marks.h"
#include "raster/save_image.h"

namespace scanlight::exercises {

namespace {

constexpr std::size_t most_complaints = 5;

std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

bool judge_numbers(const Exercise& exercise) {
    const Checks checks = exercise.checks();
    const auto& wrong = checks.wrong();
    std::printf("numbers: %zu of %d right\n",
                static_cast<std::size_t>(checks.count()) - wrong.size(), checks.count());
    for (std::size_t i = 0; i < wrong.size() && i < most_complaints; ++i)
        std::printf("  %s\n", wrong[i].c_str());
    if (wrong.size() > most_complaints)
        std::printf("  and %zu more\n", wrong.size() - most_complaints);
    return wrong.empty();
}

void say(const raster::Marks& marks, std::string_view mistake) {
    std::printf("picture: %.1f %% of its pixels right\n", std::floor(1000 * marks.share()) / 10);
    if (!mistake.empty())
        std::printf("  perhaps %.*s\n", static_cast<int>(mistake.size()), mistake.data());
}

bool judge_picture(const Exercise& exercise, const std::filesystem::path& folder) {
    const raster::AnyImage yours = exercise.yours();
    const raster::AnyImage right = exercise.right();
    const double tolerance = exercise.tolerance_levels / 255.0;
    const raster::Marks marks = raster::marks_of(yours, right, tolerance);
    const bool is_right = marks.right == marks.judged;
    say(marks, is_right ? std::string_view() : raster::likely_mistake(yours, right, tolerance));
    const auto save = [&](const std::string& ending, const raster::AnyImage& image) {
        const std::string path = (folder / (exercise.name + ending + ".png")).string();
        raster::save_image(path, image);
        std::printf("  %s\n", path.c_str());
    };
    save("", yours);
    save("-right", right);
    save("-difference", raster::difference_image(right, yours));
    return is_right;
}

int judge_all(const Exercise& exercise, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const bool has_numbers = judge_numbers(exercise);
    const bool has_picture = judge_picture(exercise, folder);
    const bool is_right = has_numbers && has_picture;
    std::printf("%s\n", is_right ? "All is right." : "Not yet: see your_part.h of this exercise.");
    return is_right ? 0 : 1;
}

}  // namespace

void Checks::number(const std::string& what, double yours, double right) {
    ++count_;
    if (std::abs(yours - right) <= 1e-6) return;
    wrong_.push_back(what + ": yours is " + text_of(yours) + ", right is " + text_of(right));
}

void Checks::answer(const std::string& what, bool yours, bool right) {
    ++count_;
    if (yours == right) return;
    wrong_.push_back(what + ": yours is " + (yours ? "yes" : "no") + ", right is " +
                     (right ? "yes" : "no"));
}

int judge(const Exercise& exercise, int argc, const char* const* argv) {
    try {
        return judge_all(exercise, argc > 1 ? argv[1] : ".");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", exercise.name.c_str(), error.what());
        return 2;
    }
}

}  // namespace scanlight::exercises
