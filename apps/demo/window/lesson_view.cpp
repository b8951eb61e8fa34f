#include "apps/demo/window/lesson_view.h"

#include <imgui.h>

#include <cfloat>
#include <utility>

#include "apps/demo/settings.h"
#include "apps/demo/window/code_draw.h"
#include "apps/demo/window/control.h"
#include "apps/demo/window/corner_handles.h"
#include "apps/demo/window/gui.h"
#include "apps/demo/window/plot_draw.h"
#include "raster/packed_image.h"

namespace scanlight::apps::window {

namespace {

/// For a first look at how much a lesson shows.
constexpr raster::Viewport sketch_size{72, 54};

std::string name_of(const LessonState& state, raster::Viewport canvas) {
    std::string name = state.lesson().name + " " + std::to_string(canvas.width) + "x" +
                       std::to_string(canvas.height);
    for (const demo::Control& control : state.lesson().controls)
        name += " " + demo::text_of(control, state.settings);
    return name;
}

demo::Screen drawn_at(const LessonState& state, raster::Viewport size) {
    return state.lesson().draw(state.settings, size, Means{});
}

raster::Viewport panel_size(const LessonLayout& layout) {
    return {layout.panels.front().width, layout.panels.front().height};
}

/// As large as they are, from the corners that the layout gives them.
std::vector<Box> picture_boxes(const demo::Screen& screen, const LessonLayout& layout) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < screen.panels.size(); ++i) {
        const raster::Image8& picture = screen.panels[i].picture;
        boxes.push_back(
            {layout.panels[i].x, layout.panels[i].y, picture.width(), picture.height()});
    }
    return boxes;
}

// ---- words

float width_of(const std::string& text, const ImFont* font) {
    return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
}

/// The largest letters in which a caption is one line; in the smallest it may be two.
const ImFont* caption_font(const std::string& text, float width) {
    for (const ImFont* font : {ImGui::GetFont(), small_font()}) {
        if (width_of(text, font) <= width) return font;
    }
    return subscript_font();
}

/// Above a box.
void draw_caption(const std::string& text, const Box& box) {
    const auto width = static_cast<float>(box.width);
    const ImFont* font = caption_font(text, width);
    const float height = width_of(text, font) <= width ? font->FontSize + 5.0f : caption_height;
    const ImVec2 at(static_cast<float>(box.x), static_cast<float>(box.y) - height);
    ImGui::GetBackgroundDrawList()->AddText(
        font, font->FontSize, at, ImGui::GetColorU32(ImGuiCol_Text), text.c_str(), nullptr, width);
}

void draw_row(const std::vector<std::string>& cells, const LessonState& state) {
    ImGui::TableNextRow();
    for (const std::string& cell : cells) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(
            demo::texts().filled(cell, state.lesson().name, state.language).c_str());
    }
}

void draw_columns(const std::vector<std::string>& columns, const LessonState& state) {
    ImGui::TableNextRow();
    for (const std::string& column : columns) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
        draw_symbol(demo::texts().filled(column, state.lesson().name, state.language));
        ImGui::PopStyleColor();
    }
}

void draw_table(const demo::Table& table, const LessonState& state) {
    const std::string title = demo::texts().of(state.lesson().name, table.key, state.language);
    ImGui::TextUnformatted(title.c_str());
    const ImGuiTableFlags flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerH |
                                  ImGuiTableFlags_NoHostExtendX;
    if (!ImGui::BeginTable(table.key.c_str(), static_cast<int>(table.columns.size()), flags))
        return;
    draw_columns(table.columns, state);
    for (const auto& row : table.rows)
        draw_row(row, state);
    ImGui::EndTable();
    ImGui::Spacing();
}

void draw_tables(const demo::Screen& screen, const LessonState& state, const Box& box) {
    if (screen.tables.empty()) return;
    ImGui::SetNextWindowPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {7.0f, 2.0f});
    ImGui::PushFont(small_font());
    ImGui::Begin("tables", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground);
    for (const demo::Table& table : screen.tables)
        draw_table(table, state);
    ImGui::End();
    ImGui::PopFont();
    ImGui::PopStyleVar(2);
}

/// Round the corner that keys move.
void draw_ring(Point at) {
    constexpr float radius = 9.0f;
    const ImVec2 middle(static_cast<float>(at.x), static_cast<float>(at.y));
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircle(middle, radius, IM_COL32(255, 255, 255, 255), 24, 4.0f);
    list.AddCircle(middle, radius, IM_COL32(184, 72, 10, 255), 24, 2.0f);
}

}  // namespace

void LessonView::paint(const LessonState& state, raster::Viewport canvas) {
    std::string wanted = name_of(state, canvas);
    if (wanted == drawn_) return;
    const bool is_same_lesson = drawn_.starts_with(state.lesson().name + " ");
    const LessonShape before = shape_of(is_same_lesson ? screen_ : drawn_at(state, sketch_size));
    demo::Screen screen = drawn_at(state, panel_size(layout_of(before, canvas)));
    const LessonShape shape = shape_of(screen);
    layout_ = layout_of(shape, canvas);
    screen_ = shape == before ? std::move(screen) : drawn_at(state, panel_size(layout_));
    pictures_ = picture_boxes(screen_, layout_);
    panel_ = panel_size(layout_);
    drawn_ = std::move(wanted);
}

void LessonView::draw_pictures(SDL_Renderer* renderer) {
    sheets_.resize(screen_.panels.size());
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
        const std::string name = drawn_ + " " + std::to_string(i);
        if (!sheets_[i].shows(name))
            sheets_[i].show(raster::packed_image(demo::marked(screen_.panels[i])), name, renderer);
        sheets_[i].draw({View::left, pictures_[i], pictures_[i]}, renderer);
    }
}

void LessonView::draw_words(const LessonState& state) const {
    const std::string& lesson = state.lesson().name;
    for (std::size_t i = 0; i < pictures_.size(); ++i)
        draw_caption(demo::texts().of(lesson, screen_.panels[i].key, state.language), pictures_[i]);
    for (std::size_t i = 0; i < screen_.plots.size(); ++i) {
        draw_caption(demo::texts().of(lesson, screen_.plots[i].key, state.language),
                     layout_.plots[i]);
        draw_plot(screen_.plots[i], lesson, state.language, layout_.plots[i]);
    }
    const auto corners = corner_places(state, sight());
    if (state.corner && *state.corner < corners.size()) draw_ring(corners[*state.corner]);
    draw_tables(screen_, state, layout_.tables);
    if (const auto step = step_shown(state, screen_))
        draw_code(demo::code_at_work(step->kind),
                  demo::texts().of("page", "code-head", state.language), layout_.code);
}

}  // namespace scanlight::apps::window
