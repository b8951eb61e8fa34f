#include "apps/demo/plot_layout.h"

#include <algorithm>
#include <cmath>

#include "apps/scanlight/text_table.h"

namespace scanlight::demo {

namespace {

constexpr double left = 50.0;
constexpr double right = 12.0;
constexpr double top = 22.0;
constexpr double line_height = 15.0;
constexpr double below_axis = 40.0;  // words of the axis

using Anchor = PlotWords::Anchor;
using Kind = PlotLine::Kind;

/// From a plot's numbers to pixels.
struct Scale {
    const Plot& plot;
    glm::dvec2 size;

    /// Room for two lines of names at least, so that plots side by side have one floor.
    double floor() const {
        const std::size_t lines = std::max<std::size_t>(2, (plot.curves.size() + 1) / 2);
        return size.y - below_axis - line_height * static_cast<double>(lines);
    }
    double end() const { return size.x - right; }
    double column(double x) const {
        return left + (end() - left) * (x - plot.x.low) / (plot.x.high - plot.x.low);
    }
    /// What leaves the plot is held at its edge.
    double row(double y) const {
        const double share = (y - plot.y.low) / (plot.y.high - plot.y.low);
        return floor() - (floor() - top) * std::clamp(share, -0.02, 1.02);
    }
    glm::dvec2 place(const glm::dvec2& p) const { return {column(p.x), row(p.y)}; }
};

/// 1, 2 or 5 times a power of ten: four to nine steps over the axis.
double step_of(const Axis& axis) {
    const double rough = (axis.high - axis.low) / 4.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= rough) return factor * power;
    return power;
}

int digits_of(double step) {
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

template <class Draw>
void for_each_tick(const Axis& axis, Draw&& draw) {
    const double step = step_of(axis);
    for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + 1e-9 * step; ++i)
        draw(i * step, apps::fixed(i == 0.0 ? 0.0 : i * step, digits_of(step)));
}

void add_grid(PlotLayout& layout, const Scale& scale) {
    for_each_tick(scale.plot.x, [&](double at, const std::string& words) {
        const double x = scale.column(at);
        layout.lines.push_back({Kind::grid, {x, top}, {x, scale.floor()}});
        layout.words.push_back({Anchor::middle, {x, scale.floor() + 14}, words});
    });
    for_each_tick(scale.plot.y, [&](double at, const std::string& words) {
        const double y = scale.row(at);
        layout.lines.push_back({Kind::grid, {left, y}, {scale.end(), y}});
        layout.words.push_back({Anchor::end, {left - 6, y + 4}, words});
    });
}

void add_axes(PlotLayout& layout, const Scale& scale) {
    const glm::dvec2 corner(left, scale.floor());
    layout.lines.push_back({Kind::axis, corner, {scale.end(), corner.y}});
    layout.lines.push_back({Kind::axis, {left, top}, corner});
    layout.words.push_back({Anchor::start, {6, 12}, "{{" + scale.plot.y.key + "}}"});
    layout.words.push_back({Anchor::middle,
                            {(left + scale.end()) / 2, scale.floor() + 28},
                            "{{" + scale.plot.x.key + "}}"});
    if (!scale.plot.here) return;
    const double x = scale.column(*scale.plot.here);
    layout.lines.push_back({Kind::here, {x, top}, {x, scale.floor()}});
}

std::vector<std::vector<glm::dvec2>> pieces_of(const Curve& curve, const Scale& scale) {
    std::vector<std::vector<glm::dvec2>> pieces;
    bool is_broken = true;
    for (const glm::dvec2& p : curve.points) {
        const bool is_gap = !std::isfinite(p.x) || !std::isfinite(p.y);
        if (!is_gap && is_broken) pieces.emplace_back();
        if (!is_gap) pieces.back().push_back(scale.place(p));
        is_broken = is_gap;
    }
    return pieces;
}

/// Two names a line, below the axis.
void add_curves(PlotLayout& layout, const Scale& scale) {
    const double column_width = (scale.size.x - left) / 2.0;
    for (std::size_t i = 0; i < scale.plot.curves.size(); ++i) {
        const Curve& curve = scale.plot.curves[i];
        const double x = left - 30 + column_width * static_cast<double>(i % 2);
        const double y = scale.floor() + below_axis + 10 + line_height * static_cast<double>(i / 2);
        layout.curves.push_back(
            {curve.key, pieces_of(curve, scale), {Kind::axis, {x, y - 4}, {x + 22, y - 4}}});
        layout.words.push_back({Anchor::start, {x + 27, y}, "{{" + curve.key + "}}"});
    }
}

}  // namespace

PlotLayout plot_layout(const Plot& plot, const glm::dvec2& size) {
    const Scale scale{plot, size};
    PlotLayout layout;
    add_grid(layout, scale);
    add_axes(layout, scale);
    add_curves(layout, scale);
    return layout;
}

}  // namespace scanlight::demo
