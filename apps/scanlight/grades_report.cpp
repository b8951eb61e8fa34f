#include "apps/scanlight/grades_report.h"

#include <cmath>

#include "apps/scanlight/text_table.h"
#include "apps/scene/json.h"

namespace scanlight::apps {

namespace {

/// Never more than was earned: 9.99 of 10 is not 10.
std::string points_text(double points) {
    return fixed(std::floor(points * 100.0 + 1e-9) / 100.0, 2);
}

std::string verdict(const CandidateGrades& candidate, const GradingRule& rule) {
    return candidate.passes(rule) ? "pass" : "fail";
}

void add_rows(TextTable& table, const CandidateGrades& candidate, const GradingRule& rule) {
    const bool has_sum = candidate.grades.size() > 1;
    for (const Grade& grade : candidate.grades) {
        table.add_row({candidate.name, grade.name, points_text(grade.points(rule)),
                       has_sum ? "" : verdict(candidate, rule), grade.remark});
    }
    if (has_sum)
        table.add_row({candidate.name, "together", points_text(candidate.points(rule)),
                       verdict(candidate, rule), "of " + points_text(candidate.most_points(rule))});
}

Json json_of(const Grade& grade, const GradingRule& rule) {
    return {{"picture", grade.name},
            {"file", grade.path},
            {"points", grade.points(rule)},
            {"judged_pixels", grade.marks.judged},
            {"right_pixels", grade.marks.right},
            {"remark", grade.remark}};
}

}  // namespace

std::string grades_text(const std::vector<CandidateGrades>& all, const GradingRule& rule) {
    TextTable table({"candidate", "picture", "points", "", "remark"});
    for (const std::size_t words : {0u, 1u, 4u})
        table.align_left(words);
    for (const CandidateGrades& candidate : all)
        add_rows(table, candidate, rule);
    return table.text("");
}

std::string grades_json(const std::vector<CandidateGrades>& all, const GradingRule& rule) {
    Json json{{"rule",
               {{"tolerance_levels", rule.tolerance_levels},
                {"points_a_picture", rule.points},
                {"pass_percent", rule.pass_percent}}},
              {"candidates", Json::array()}};
    for (const CandidateGrades& candidate : all) {
        Json pictures = Json::array();
        for (const Grade& grade : candidate.grades)
            pictures.push_back(json_of(grade, rule));
        json["candidates"].push_back({{"candidate", candidate.name},
                                      {"points", candidate.points(rule)},
                                      {"of", candidate.most_points(rule)},
                                      {"passes", candidate.passes(rule)},
                                      {"pictures", pictures}});
    }
    return json_text(json);
}

}  // namespace scanlight::apps
