#include "apps/peers/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>

namespace scanlight::peers {

namespace {

// In units of the picture.
constexpr double panel_width = 460;
constexpr double panel_height = 300;
constexpr double left = 50;    // of a panel's edge to its axis
constexpr double right = 120;  // room for the curves' names
constexpr double top = 40;
constexpr double bottom = 40;

constexpr std::array colors = {"#1b6ca8", "#c4501b", "#2e7d32", "#7b3fa0", "#8a6d00", "#555555"};

/// From a value's logarithm to the height at which it is drawn.
class Scale {
public:
    explicit Scale(const Panel& panel) {
        for (const Curve& curve : panel.curves) {
            for (const double value : curve.values) {
                low_ = std::min(low_, value);
                high_ = std::max(high_, value);
            }
        }
        low_ *= 0.8;
        high_ *= 1.25;
    }

    double y(double value) const {
        const double part = std::log(value / low_) / std::log(high_ / low_);
        return panel_height - bottom - part * (panel_height - top - bottom);
    }

    /// 1, 2 and 5 times powers of ten between the ends.
    std::vector<double> ticks() const {
        std::vector<double> result;
        for (double power = 1e-3; power < 1e6; power *= 10) {
            for (const double factor : {1.0, 2.0, 5.0}) {
                const double tick = power * factor;
                if (tick >= low_ && tick <= high_) result.push_back(tick);
            }
        }
        return result;
    }

private:
    double low_ = 1e9;
    double high_ = 0.0;
};

double x_of(const Panel& panel, std::size_t place) {
    const double last = static_cast<double>(std::max<std::size_t>(panel.places.size(), 2) - 1);
    return left + 10 + static_cast<double>(place) / last * (panel_width - left - right - 20);
}

void write_text(std::ostream& out, double x, double y, const char* anchor, const std::string& text,
                const char* color = "#333333") {
    out << "<text x='" << x << "' y='" << y << "' text-anchor='" << anchor << "' fill='" << color
        << "'>" << text << "</text>\n";
}

void draw_axes(std::ostream& out, const Panel& panel, const Scale& scale) {
    out << "<text x='" << left << "' y='20' font-weight='bold' fill='#111111'>" << panel.title
        << "</text>\n";
    for (const double tick : scale.ticks()) {
        const double y = scale.y(tick);
        out << "<path d='M" << left << ' ' << y << "H" << panel_width - right
            << "' stroke='#dddddd'/>\n";
        std::string text = std::to_string(tick);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        write_text(out, left - 6, y + 4, "end", text);
    }
    for (std::size_t i = 0; i < panel.places.size(); ++i)
        write_text(out, x_of(panel, i), panel_height - bottom + 20, "middle", panel.places[i]);
}

void draw_curve(std::ostream& out, const Panel& panel, const Curve& curve, const Scale& scale,
                const char* color) {
    out << "<path fill='none' stroke-width='2' stroke='" << color << "' d='";
    for (std::size_t i = 0; i < curve.values.size(); ++i)
        out << (i == 0 ? 'M' : 'L') << x_of(panel, i) << ' ' << scale.y(curve.values[i]);
    out << "'/>\n";
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
        out << "<circle r='3' cx='" << x_of(panel, i) << "' cy='" << scale.y(curve.values[i])
            << "' fill='" << color << "'/>\n";
    }
}

/// Names at the curves' right ends, pushed apart where they would overlap.
void draw_names(std::ostream& out, const Panel& panel, const Scale& scale) {
    std::vector<std::size_t> order(panel.curves.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const auto end_of = [&](std::size_t i) { return scale.y(panel.curves[i].values.back()); };
    std::ranges::stable_sort(order, [&](auto a, auto b) { return end_of(a) < end_of(b); });
    double lowest = 0.0;
    for (const std::size_t i : order) {
        lowest = std::max(lowest + 14, end_of(i) + 4);
        write_text(out, panel_width - right + 2, lowest, "start", panel.curves[i].name,
                   colors[i % colors.size()]);
    }
}

void draw_panel(std::ostream& out, const Panel& panel) {
    const Scale scale(panel);
    draw_axes(out, panel, scale);
    for (std::size_t i = 0; i < panel.curves.size(); ++i)
        draw_curve(out, panel, panel.curves[i], scale, colors[i % colors.size()]);
    draw_names(out, panel, scale);
}

}  // namespace

void print_table(std::ostream& out, const Panel& panel) {
    out << '\n' << std::left << std::setw(34) << panel.title << std::right;
    for (const std::string& place : panel.places)
        out << std::setw(11) << place;
    out << '\n';
    for (const Curve& curve : panel.curves) {
        out << "  " << std::left << std::setw(32) << curve.name << std::right << std::fixed
            << std::setprecision(2);
        for (const double value : curve.values)
            out << std::setw(11) << value;
        out << '\n';
    }
}

void draw_chart(std::ostream& out, const std::vector<Panel>& panels) {
    const auto rows = static_cast<double>((panels.size() + 1) / 2);
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << 2 * panel_width << "' height='"
        << rows * panel_height << "' font-family='sans-serif' font-size='12'>\n"
        << "<rect width='100%' height='100%' fill='white'/>\n";
    for (std::size_t i = 0; i < panels.size(); ++i) {
        out << "<g transform='translate(" << static_cast<double>(i % 2) * panel_width << ' '
            << static_cast<double>(i / 2) * panel_height << ")'>\n";
        draw_panel(out, panels[i]);
        out << "</g>\n";
    }
    out << "</svg>\n";
}

}  // namespace scanlight::peers
