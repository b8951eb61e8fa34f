#include "apps/demo/window/plot_draw.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "apps/demo/plot_layout.h"
#include "apps/demo/window/gui.h"

namespace scanlight::apps::window {

namespace {

using demo::PlotLayout;
using demo::PlotLine;
using demo::PlotWords;

constexpr ImU32 ground = IM_COL32(24, 25, 27, 255);
constexpr ImU32 ink = IM_COL32(205, 207, 212, 255);
constexpr ImU32 curve_colors[] = {IM_COL32(255, 154, 82, 255), IM_COL32(125, 179, 255, 255),
                                  IM_COL32(116, 207, 128, 255), IM_COL32(207, 155, 245, 255),
                                  IM_COL32(176, 179, 186, 255)};

/// The channels of colour have their own; else it goes by the curve's number.
ImU32 color_of(const std::string& key, std::size_t number) {
    if (key == "red") return IM_COL32(240, 86, 76, 255);
    if (key == "green") return IM_COL32(84, 200, 118, 255);
    if (key == "blue") return IM_COL32(98, 150, 255, 255);
    return curve_colors[number % std::size(curve_colors)];
}

ImU32 color_of(PlotLine::Kind kind) {
    switch (kind) {
        case PlotLine::Kind::grid:
            return IM_COL32(52, 54, 58, 255);
        case PlotLine::Kind::axis:
            return IM_COL32(130, 133, 140, 255);
        case PlotLine::Kind::here:
            break;
    }
    return IM_COL32(220, 60, 90, 255);
}

/// Draws at a corner of the window.
class Pen {
public:
    Pen(const Box& box, const std::string& lesson, demo::Language language)
        : corner_(static_cast<float>(box.x), static_cast<float>(box.y)),
          lesson_(lesson),
          language_(language) {}

    /// Upright or level, as all lines of a plot are.
    void line(const PlotLine& line, ImU32 color, float width) const {
        const ImVec2 from = at(line.from);
        const ImVec2 to = at(line.to);
        const float half = 0.5f * width;
        list().AddRectFilled({std::round(from.x - half), std::round(std::min(from.y, to.y) - half)},
                             {std::round(to.x + half), std::round(std::max(from.y, to.y) + half)},
                             color);
    }

    void words(const PlotWords& words) const {
        const std::string text = demo::texts().filled(words.words, lesson_, language_);
        const ImFont& font = *small_font();
        const float width = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.c_str()).x;
        const float share = words.anchor == PlotWords::Anchor::start    ? 0.0f
                            : words.anchor == PlotWords::Anchor::middle ? 0.5f
                                                                        : 1.0f;
        const ImVec2 place = at(words.at);
        list().AddText(&font, font.FontSize, {place.x - share * width, place.y - font.Ascent}, ink,
                       text.c_str());
    }

    void curve(const demo::PlotCurve& curve, std::size_t number) const {
        const ImU32 color = color_of(curve.key, number);
        for (const auto& piece : curve.pieces) {
            std::vector<ImVec2> points;
            for (const glm::dvec2& p : piece)
                points.push_back(at(p));
            stroke(points, color);
        }
        line(curve.sample, color, 2.0f);
    }

private:
    /// In whole triangles: soft edges have such thin ones that a software renderer loses some.
    static void stroke(const std::vector<ImVec2>& points, ImU32 color) {
        list().Flags &= ~ImDrawListFlags_AntiAliasedLines;
        list().AddPolyline(points.data(), static_cast<int>(points.size()), color, 0, 2.0f);
        list().Flags |= ImDrawListFlags_AntiAliasedLines;
    }
    static ImDrawList& list() { return *ImGui::GetBackgroundDrawList(); }
    ImVec2 at(const glm::dvec2& p) const {
        return {corner_.x + static_cast<float>(p.x), corner_.y + static_cast<float>(p.y)};
    }

    ImVec2 corner_;
    const std::string& lesson_;
    demo::Language language_;
};

}  // namespace

void draw_plot(const demo::Plot& plot, const std::string& lesson, demo::Language language,
               const Box& box) {
    const PlotLayout layout =
        demo::plot_layout(plot, {static_cast<double>(box.width), static_cast<double>(box.height)});
    ImGui::GetBackgroundDrawList()->AddRectFilled(
        {static_cast<float>(box.x), static_cast<float>(box.y)},
        {static_cast<float>(box.x + box.width), static_cast<float>(box.y + box.height)}, ground);
    const Pen pen(box, lesson, language);
    for (const PlotLine& line : layout.lines)
        pen.line(line, color_of(line.kind), 1.0f);
    for (std::size_t i = 0; i < layout.curves.size(); ++i)
        pen.curve(layout.curves[i], i);
    for (const PlotWords& words : layout.words)
        pen.words(words);
}

}  // namespace scanlight::apps::window
