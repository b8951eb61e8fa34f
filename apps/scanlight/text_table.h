#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace scanlight::apps {

/// Columns of words, each as wide as its widest word; to the right, as numbers are, or to the left.
/// UTF-8.
class TextTable {
public:
    explicit TextTable(std::vector<std::string> header);

    void add_row(std::vector<std::string> row);

    /// Its words begin below one another.
    void align_left(std::size_t column) { left_.insert(column); }

    /// Each line begins with `indent` and ends without trailing blanks.
    std::string text(const std::string& indent) const;

private:
    std::vector<std::vector<std::string>> rows_;  // the header first
    std::set<std::size_t> left_;
};

/// A number with a fixed count of digits after the point.
std::string fixed(double value, int digits);

}  // namespace scanlight::apps
