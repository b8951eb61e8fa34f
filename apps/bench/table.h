#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace scanlight::bench {

/// One line: what was measured, and the key of each column's measurement.
struct Row {
    std::string group;
    std::string label;
    std::vector<std::string> keys;
};

struct Table {
    std::string unit;  // "nanoseconds a pixel"
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

/// Prints two blocks: the values themselves, then each as a multiple of the first row of its group.
void print(std::ostream& out, const Table& table,
           const std::function<double(const std::string& key)>& value_of);

}  // namespace scanlight::bench
