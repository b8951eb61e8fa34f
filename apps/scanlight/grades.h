#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "raster/image.h"
#include "raster/marks.h"

namespace scanlight::apps {

/// How points are given.
struct GradingRule {
    double tolerance_levels = 0;  // of 255
    double points = 10;           // for a picture that is all right
    double pass_percent = 100;    // of a candidate's points
};

/// A picture as it should be, under the name that candidates' folders have it by.
struct ReferencePicture {
    std::string name;
    raster::AnyImage image;
};

/// What one picture earns.
struct Grade {
    std::string name;  // the reference's
    std::string path;  // the candidate's file
    raster::Marks marks{1, 0};
    std::string remark;  // for a person; empty where there is nothing to say

    double points(const GradingRule& rule) const { return rule.points * marks.share(); }
};

struct CandidateGrades {
    std::string name;  // as given
    std::vector<Grade> grades;

    double points(const GradingRule& rule) const;
    double most_points(const GradingRule& rule) const;
    bool passes(const GradingRule& rule) const;
};

/// One of a file, or those of a folder, by name. Throws for what is no picture, and for a folder
/// without one.
std::vector<ReferencePicture> reference_pictures(const std::string& path);

/// A candidate that is a file is held against the one reference there is; one that is a folder has
/// files of the references' names. Never throws for what a candidate holds.
CandidateGrades grades_of(const std::string& candidate,
                          const std::vector<ReferencePicture>& references, const GradingRule& rule);

/// CANDIDATE-NAME.png in the folder for each picture that is of the reference's size and not all
/// right.
void save_differences(const std::string& folder, const std::vector<ReferencePicture>& references,
                      const std::vector<CandidateGrades>& all);

}  // namespace scanlight::apps
