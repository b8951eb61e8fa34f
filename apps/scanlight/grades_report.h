#pragma once

#include <string>
#include <vector>

#include "apps/scanlight/grades.h"

namespace scanlight::apps {

/// A table for people: a line a picture, and a sum for each candidate with several.
std::string grades_text(const std::vector<CandidateGrades>& all, const GradingRule& rule);

/// The same for programs.
std::string grades_json(const std::vector<CandidateGrades>& all, const GradingRule& rule);

}  // namespace scanlight::apps
