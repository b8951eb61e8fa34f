#include "apps/demo/plot_svg.h"

#include "apps/demo/plot_layout.h"
#include "apps/scanlight/text_table.h"

namespace scanlight::demo {

namespace {

constexpr glm::dvec2 size{420.0, 236.0};

using apps::fixed;

std::string pixels(double value) {
    return fixed(value, 1);
}

std::string svg_of(const std::string& kind, const PlotLine& line) {
    return "<line class='" + kind + "' x1='" + pixels(line.from.x) + "' y1='" +
           pixels(line.from.y) + "' x2='" + pixels(line.to.x) + "' y2='" + pixels(line.to.y) +
           "'/>";
}

std::string word_of(PlotLine::Kind kind) {
    switch (kind) {
        case PlotLine::Kind::grid:
            return "grid";
        case PlotLine::Kind::axis:
            return "axis";
        case PlotLine::Kind::here:
            break;
    }
    return "here";
}

std::string word_of(PlotWords::Anchor anchor) {
    switch (anchor) {
        case PlotWords::Anchor::start:
            return "start";
        case PlotWords::Anchor::middle:
            return "middle";
        case PlotWords::Anchor::end:
            break;
    }
    return "end";
}

std::string svg_of(const PlotWords& words) {
    return "<text x='" + pixels(words.at.x) + "' y='" + pixels(words.at.y) + "' text-anchor='" +
           word_of(words.anchor) + "'>" + words.words + "</text>";
}

/// "M1,2 3,4M5,6 7,8": each M begins a piece.
std::string path_of(const PlotCurve& curve) {
    std::string path;
    for (const auto& piece : curve.pieces) {
        for (const glm::dvec2& p : piece)
            path += (&p == &piece.front() ? "M" : " ") + pixels(p.x) + "," + pixels(p.y);
    }
    return path;
}

std::string svg_of(const PlotCurve& curve, std::size_t number) {
    const std::string kind = "curve c" + std::to_string(number) + " key-" + curve.key;
    return "<path class='" + kind + "' d='" + path_of(curve) + "'/>" + svg_of(kind, curve.sample);
}

}  // namespace

std::string plot_svg(const Plot& plot) {
    const PlotLayout layout = plot_layout(plot, size);
    std::string svg = "<svg viewBox='0 0 " + fixed(size.x, 0) + " " + fixed(size.y, 0) +
                      "' role='img' aria-label='{{" + plot.key + "}}'>";
    for (const PlotLine& line : layout.lines)
        svg += svg_of(word_of(line.kind), line);
    for (std::size_t i = 0; i < layout.curves.size(); ++i)
        svg += svg_of(layout.curves[i], i);
    for (const PlotWords& words : layout.words)
        svg += svg_of(words);
    return svg + "</svg>";
}

}  // namespace scanlight::demo
