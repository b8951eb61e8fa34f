#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace scanlight::peers {

/// Milliseconds, one for each place of a panel.
struct Curve {
    std::string name;
    std::vector<double> values;
};

/// What depends on one thing; its places stand side by side.
struct Panel {
    std::string title;
    std::vector<std::string> places;
    std::vector<Curve> curves;
};

/// A table: a row a curve, a column a place.
void print_table(std::ostream& out, const Panel& panel);

/// Scalable Vector Graphics: the panels in two columns, milliseconds upward on a logarithmic scale.
/// Requires positive values.
void draw_chart(std::ostream& out, const std::vector<Panel>& panels);

}  // namespace scanlight::peers
