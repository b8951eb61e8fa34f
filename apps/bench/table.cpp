#include "apps/bench/table.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <ostream>

namespace scanlight::bench {

namespace {

constexpr int label_width = 32;
constexpr std::size_t narrowest_column = 9;

int column_width(const std::string& name) {
    return static_cast<int>(std::max(narrowest_column, name.size() + 2));
}

void print_header(std::ostream& out, const std::string& title, const Table& table) {
    out << '\n' << std::left << std::setw(label_width) << title << std::right;
    for (const std::string& column : table.columns)
        out << std::setw(column_width(column)) << column;
    out << '\n';
}

/// `cell(row, column)` for each row under the name of its group.
template <class Cell>
void print_rows(std::ostream& out, const Table& table, Cell&& cell) {
    std::string group;
    for (const Row& row : table.rows) {
        if (row.group != group) out << row.group << '\n';
        group = row.group;
        out << std::left << std::setw(label_width) << "  " + row.label << std::right;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            out << std::setw(column_width(table.columns[i])) << cell(row, i);
        }
        out << '\n';
    }
}

const Row& first_of_group(const Table& table, const std::string& group) {
    std::size_t i = 0;
    while (table.rows[i].group != group)
        ++i;
    return table.rows[i];
}

}  // namespace

void print(std::ostream& out, const Table& table,
           const std::function<double(const std::string& key)>& value_of) {
    out << std::fixed << std::setprecision(2);
    print_header(out, table.unit, table);
    print_rows(out, table, [&](const Row& row, std::size_t i) { return value_of(row.keys[i]); });
    print_header(out, "multiples of each first row", table);
    print_rows(out, table, [&](const Row& row, std::size_t i) {
        return value_of(row.keys[i]) / value_of(first_of_group(table, row.group).keys[i]);
    });
}

}  // namespace scanlight::bench
