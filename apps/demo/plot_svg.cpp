#include "apps/demo/plot_svg.h"

#include <algorithm>
#include <cmath>

#include "apps/scanlight/text_table.h"

namespace scanlight::demo {

namespace {

constexpr double width = 420.0;
constexpr double height = 236.0;
constexpr double left = 50.0;
constexpr double right = 12.0;
constexpr double top = 22.0;
constexpr double bottom = 70.0;

using apps::fixed;

std::string pixels(double value) {
    return fixed(value, 1);
}

double column(const Plot& plot, double x) {
    return left + (width - left - right) * (x - plot.x.low) / (plot.x.high - plot.x.low);
}

/// What leaves the plot is held at its edge.
double row(const Plot& plot, double y) {
    const double share = (y - plot.y.low) / (plot.y.high - plot.y.low);
    return height - bottom - (height - top - bottom) * std::clamp(share, -0.02, 1.02);
}

std::string line(const std::string& kind, double x1, double y1, double x2, double y2) {
    return "<line class='" + kind + "' x1='" + pixels(x1) + "' y1='" + pixels(y1) + "' x2='" +
           pixels(x2) + "' y2='" + pixels(y2) + "'/>";
}

std::string text(const std::string& anchor, double x, double y, const std::string& words) {
    return "<text x='" + pixels(x) + "' y='" + pixels(y) + "' text-anchor='" + anchor + "'>" +
           words + "</text>";
}

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
std::string ticks(const Axis& axis, Draw&& draw) {
    std::string svg;
    const double step = step_of(axis);
    for (double i = std::ceil(axis.low / step - 1e-9); i * step <= axis.high + 1e-9 * step; ++i)
        svg += draw(i * step, fixed(i == 0.0 ? 0.0 : i * step, digits_of(step)));
    return svg;
}

std::string grid(const Plot& plot) {
    const double floor = height - bottom;
    return ticks(plot.x,
                 [&](double at, const std::string& words) {
                     const double x = column(plot, at);
                     return line("grid", x, top, x, floor) + text("middle", x, floor + 14, words);
                 }) +
           ticks(plot.y, [&](double at, const std::string& words) {
               const double y = row(plot, at);
               return line("grid", left, y, width - right, y) + text("end", left - 6, y + 4, words);
           });
}

/// In pieces, where it breaks off.
std::string curve(const Plot& plot, const Curve& curve, std::size_t number) {
    std::string path;
    bool is_broken = true;
    for (const glm::dvec2& p : curve.points) {
        const bool is_gap = !std::isfinite(p.x) || !std::isfinite(p.y);
        if (!is_gap)
            path +=
                (is_broken ? "M" : " ") + pixels(column(plot, p.x)) + "," + pixels(row(plot, p.y));
        is_broken = is_gap;
    }
    return "<path class='curve c" + std::to_string(number) + " key-" + curve.key + "' d='" + path +
           "'/>";
}

/// Below the axis there is room for two lines of names; more make the picture higher.
double full_height(const Plot& plot) {
    const auto lines = static_cast<double>((plot.curves.size() + 1) / 2);
    return height + 15.0 * std::max(0.0, lines - 2.0);
}

/// Two names a line, below the axis.
std::string legend(const Plot& plot) {
    std::string svg;
    const double column_width = (width - left) / 2.0;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const double x = left - 30 + column_width * static_cast<double>(i % 2);
        const double y = height - 20 + 15 * static_cast<double>(i / 2);
        svg += line("curve c" + std::to_string(i) + " key-" + plot.curves[i].key, x, y - 4, x + 22,
                    y - 4) +
               text("start", x + 27, y, "{{" + plot.curves[i].key + "}}");
    }
    return svg;
}

}  // namespace

std::string plot_svg(const Plot& plot) {
    std::string svg = "<svg viewBox='0 0 " + fixed(width, 0) + " " + fixed(full_height(plot), 0) +
                      "' role='img' aria-label='{{" + plot.key + "}}'>" + grid(plot);
    svg += line("axis", left, height - bottom, width - right, height - bottom) +
           line("axis", left, top, left, height - bottom);
    if (plot.here)
        svg +=
            line("here", column(plot, *plot.here), top, column(plot, *plot.here), height - bottom);
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        svg += curve(plot, plot.curves[i], i);
    svg += text("start", 6, 12, "{{" + plot.y.key + "}}");
    svg +=
        text("middle", (left + width - right) / 2, height - bottom + 28, "{{" + plot.x.key + "}}");
    return svg + legend(plot) + "</svg>";
}

}  // namespace scanlight::demo
