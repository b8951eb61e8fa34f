#include "apps/scanlight/grades.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "apps/scene/usage_error.h"
#include "raster/compare.h"
#include "raster/load_image.h"
#include "raster/save_image.h"

namespace scanlight::apps {

namespace {

namespace fs = std::filesystem;

bool is_picture_name(const fs::path& path) {
    static const std::string_view endings[] = {".png", ".jpg", ".jpeg", ".ppm",
                                               ".pgm", ".pfm", ".hdr"};
    return std::ranges::find(endings, path.extension().string()) != std::end(endings);
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file() && is_picture_name(entry.path())) paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    return paths;
}

std::string right_pixels(const raster::Marks& marks) {
    return std::to_string(marks.judged - marks.right) + " of " + std::to_string(marks.judged) +
           " pixels are wrong";
}

/// Of pictures that can be compared.
void judge(const raster::AnyImage& image, const raster::AnyImage& reference, double tolerance,
           Grade& grade) {
    grade.marks = raster::marks_of(image, reference, tolerance);
    if (grade.marks.right == grade.marks.judged) return;
    const std::string_view mistake = raster::likely_mistake(image, reference, tolerance);
    grade.remark = mistake.empty() ? right_pixels(grade.marks) : std::string(mistake);
}

Grade grade_of(const fs::path& path, const ReferencePicture& reference, const GradingRule& rule) {
    Grade grade;
    grade.name = reference.name;
    grade.path = path.string();
    if (!fs::exists(path)) {
        grade.remark = "missing";
        return grade;
    }
    try {
        judge(raster::load_image(path.string()), reference.image, rule.tolerance_levels / 255.0,
              grade);
    } catch (const std::runtime_error& error) {
        grade.remark = error.what();
    }
    return grade;
}

/// "students/ada/" as a part of a file's name.
std::string as_file_name(std::string name) {
    while (name.size() > 1 && name.back() == '/')
        name.pop_back();
    return fs::path(name).stem().string();
}

/// None where the two cannot be compared.
std::optional<raster::Image8> difference_of(const Grade& grade, const ReferencePicture& reference) {
    try {
        return raster::difference_image(reference.image, raster::load_image(grade.path));
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace

double CandidateGrades::points(const GradingRule& rule) const {
    double sum = 0;
    for (const Grade& grade : grades)
        sum += grade.points(rule);
    return sum;
}

double CandidateGrades::most_points(const GradingRule& rule) const {
    return rule.points * static_cast<double>(grades.size());
}

bool CandidateGrades::passes(const GradingRule& rule) const {
    return points(rule) * 100.0 >= most_points(rule) * rule.pass_percent;
}

std::vector<ReferencePicture> reference_pictures(const std::string& path) {
    if (!fs::is_directory(path))
        return {{fs::path(path).filename().string(), raster::load_image(path)}};
    std::vector<ReferencePicture> references;
    for (const fs::path& picture : pictures_in(path))
        references.push_back({picture.filename().string(), raster::load_image(picture.string())});
    if (references.empty()) throw UsageError(path + ": there is no picture in this folder");
    return references;
}

CandidateGrades grades_of(const std::string& candidate,
                          const std::vector<ReferencePicture>& references,
                          const GradingRule& rule) {
    const bool is_folder = fs::is_directory(candidate);
    if (!is_folder && references.size() > 1)
        throw UsageError(candidate + ": expected a folder, as the reference is one of " +
                         std::to_string(references.size()) + " pictures");
    CandidateGrades result{candidate, {}};
    for (const ReferencePicture& reference : references) {
        const fs::path path =
            is_folder ? fs::path(candidate) / reference.name : fs::path(candidate);
        result.grades.push_back(grade_of(path, reference, rule));
    }
    return result;
}

void save_differences(const std::string& folder, const std::vector<ReferencePicture>& references,
                      const std::vector<CandidateGrades>& all) {
    fs::create_directories(folder);
    for (const CandidateGrades& candidate : all) {
        for (std::size_t i = 0; i < references.size(); ++i) {
            const Grade& grade = candidate.grades[i];
            if (grade.remark.empty()) continue;
            const auto difference = difference_of(grade, references[i]);
            if (!difference) continue;
            const std::string name =
                as_file_name(candidate.name) + "-" + as_file_name(references[i].name) + ".png";
            raster::save_image((fs::path(folder) / name).string(), *difference);
        }
    }
}

}  // namespace scanlight::apps
