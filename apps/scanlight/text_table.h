#pragma once

#include <string>
#include <vector>

namespace scanlight::apps {

/// Columns of words, each as wide as its widest word, numbers to the right. UTF-8.
class TextTable {
public:
    explicit TextTable(std::vector<std::string> header);

    void add_row(std::vector<std::string> row);

    /// Each line begins with `indent` and ends without trailing blanks.
    std::string text(const std::string& indent) const;

private:
    std::vector<std::vector<std::string>> rows_;  // the header first
};

/// A number with a fixed count of digits after the point.
std::string fixed(double value, int digits);

}  // namespace scanlight::apps
