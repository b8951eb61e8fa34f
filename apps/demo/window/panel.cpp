#include "apps/demo/window/panel.h"

#include <imgui.h>

#include <filesystem>
#include <utility>

#include "apps/demo/window/control.h"
#include "apps/demo/window/course_list.h"
#include "apps/demo/window/light_handles.h"
#include "mesh/shapes.h"

namespace scanlight::apps::window {

namespace {

constexpr float symbol_column = 34.0f;
constexpr float control_column = 164.0f;
constexpr float news_height = 122.0f;  // always the same, so that no control jumps

constexpr const char* help =
    "Drag to turn, with the right button to move, the wheel to enlarge; drag a light by its disc. "
    "1 to 4 arrange the views, Tab takes the other, F frames, L is the loupe, P holds its pixel, C "
    "is "
    "the course.";

constexpr std::pair<Arrangement, const char*> arrangements[] = {
    {Arrangement::one, "One"},
    {Arrangement::wipe, "Wipe"},
    {Arrangement::beside, "Beside"},
    {Arrangement::difference, "Difference"}};

constexpr std::pair<View, const char*> views[] = {{View::left, "View A"}, {View::right, "View B"}};

bool is_open_at_first(const std::string& group) {
    return group != "Camera" && group != "Surroundings" && group != "Textures";
}

void begin_window(int x, int height) {
    ImGui::SetNextWindowPos({static_cast<float>(x), 0.0f});
    ImGui::SetNextWindowSize({static_cast<float>(Panel::width), static_cast<float>(height)});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
}

/// A command line can carry a whole scene.
std::string shortened(const std::string& message) {
    constexpr std::size_t most = 200;
    return message.size() <= most ? message : message.substr(0, most) + " \xE2\x80\xA6";
}

void explain(const std::string& text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(320.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void draw_news(const PanelNews& news) {
    ImGui::Separator();
    ImGui::TextDisabled("%zu polygons, drawn in %.1f ms", news.polygons, news.picture_milliseconds);
    ImGui::PushTextWrapPos(0.0f);
    if (news.message.empty()) {
        ImGui::TextDisabled("%s", help);
    } else {
        ImGui::TextUnformatted(shortened(news.message).c_str());
    }
    ImGui::PopTextWrapPos();
}

}  // namespace

Panel::Panel() : parameters_(window::parameters()) {
    for (const mesh::ShapeInfo& shape : mesh::list_shapes())
        shapes_.push_back(shape.name);
}

Panel::Result Panel::draw(WindowState state, const PanelNews& news, int x, int height) {
    places_.clear();
    begin_window(x, height);
    draw_arrangements(state);
    draw_views(state);
    draw_shapes(state);
    const Wish wish = draw_wishes();
    ImGui::Separator();
    ImGui::BeginChild("parameters", {0.0f, -news_height});
    draw_parameters(state, news);
    draw_lights(state, news);
    ImGui::EndChild();
    draw_news(news);
    ImGui::End();
    return {std::move(state), wish};
}

void Panel::note_place(const std::string& name) {
    places_[name] = place_of_item();
}

bool Panel::draw_button(const std::string& name, const std::string& label, Look look) {
    const bool is_chosen = look == Look::chosen;
    if (is_chosen)
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab));
    const bool is_pressed = ImGui::Button(label.c_str());
    if (is_chosen) ImGui::PopStyleColor();
    note_place(name);
    return is_pressed;
}

void Panel::draw_arrangements(WindowState& state) {
    for (const auto& [arrangement, name] : arrangements) {
        const Look look = state.arrangement == arrangement ? Look::chosen : Look::plain;
        if (draw_button(name, name, look)) state = arranged(std::move(state), arrangement);
        ImGui::SameLine();
    }
    bool is_open = state.loupe == Loupe::open;
    if (ImGui::Checkbox("Loupe", &is_open)) state.loupe = is_open ? Loupe::open : Loupe::closed;
    note_place("Loupe");
    explain("All that is known of the pixel under the mouse (L). P holds it fast.");
}

void Panel::draw_views(WindowState& state) {
    for (const auto& [view, name] : views) {
        if (draw_button(name, name, state.chosen == view ? Look::chosen : Look::plain))
            state.chosen = view;
        ImGui::SameLine();
    }
    const std::string alike = state.chosen == View::left ? "B as A" : "A as B";
    if (draw_button("alike", alike, Look::plain)) state = with_other_alike(std::move(state));
    explain("The other view takes over all settings of this one.");
}

void Panel::draw_shapes(WindowState& state) {
    const std::string input = std::filesystem::path(state.current().input).filename().string();
    ImGui::SetNextItemWidth(190.0f);
    const bool is_open = ImGui::BeginCombo("##shape", input.c_str());
    note_place("shape");
    if (is_open) {
        for (const std::string& shape : shapes_) {
            if (ImGui::Selectable(shape.c_str(), shape == input))
                state = with_input(std::move(state), "shape:" + shape);
        }
        ImGui::EndCombo();
    }
    explain("A built-in shape. Files are dropped into the window.");
    ImGui::SameLine();
    if (draw_button("frame", "Frame", Look::plain))
        state = framed(std::move(state), render::ViewAngles{});
    explain("Look at all of it, from the usual side (F).");
    ImGui::SameLine();
    state = draw_course_list(std::move(state), -1.0f, places_);
}

Wish Panel::draw_wishes() {
    Wish wish = Wish::nothing;
    if (draw_button("save picture", "Save picture", Look::plain)) wish = Wish::save_picture;
    ImGui::SameLine();
    if (draw_button("save scene", "Save scene", Look::plain)) wish = Wish::save_scene;
    ImGui::SameLine();
    if (draw_button("copy", "Copy command", Look::plain)) wish = Wish::copy_command_line;
    explain("The command line that draws the picture of this view, to the clipboard.");
    return wish;
}

bool Panel::begin_group(const std::string& group) {
    ImGui::Spacing();
    const bool is_open = ImGui::CollapsingHeader(
        group.c_str(), is_open_at_first(group) ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    note_place(group);
    return is_open;
}

void Panel::draw_row(WindowState& state, const Parameter& parameter, const PanelNews& news) {
    const auto value = shown_value(parameter, state.current(), news.material);
    ImGui::AlignTextToFramePadding();
    ImGui::PushID(parameter.name.c_str());
    ImGui::BeginGroup();
    draw_symbol(parameter.symbol);
    ImGui::SameLine(symbol_column);
    ImGui::TextDisabled("%s", parameter.name.c_str());
    ImGui::EndGroup();
    explain(parameter.knob.info.meaning);
    ImGui::SameLine(control_column);
    if (const auto changed = draw_control(parameter, value))
        state.current() = with_value(std::move(state.current()), parameter, *changed);
    note_place(parameter.name);
    ImGui::PopID();
}

void Panel::draw_parameters(WindowState& state, const PanelNews& news) {
    std::string group;
    bool is_open = false;
    for (const Parameter& parameter : parameters_) {
        if (parameter.group != group) {
            group = parameter.group;
            is_open = begin_group(group);
        }
        if (is_open && applies(parameter, state.current())) draw_row(state, parameter, news);
    }
}

void Panel::draw_lights(WindowState& state, const PanelNews& news) {
    if (!begin_group("Lights")) return;
    const std::size_t count = lights_in(state.current()).size();
    while (of_lights_.size() < count)
        of_lights_.push_back(light_parameters(of_lights_.size()));
    for (std::size_t i = 0; i < count; ++i) {
        for (const Parameter& parameter : of_lights_[i]) {
            if (applies(parameter, state.current())) draw_row(state, parameter, news);
        }
    }
    draw_light_buttons(state, news);
}

void Panel::draw_light_buttons(WindowState& state, const PanelNews& news) {
    SceneOptions& view = state.current();
    if (draw_button("add light", "Add light", Look::plain))
        view = with_more_light(std::move(view), {LightFrame::camera, {0.8, 0.3, 0.5}});
    ImGui::SameLine();
    if (draw_button("add lamp", "Add lamp", Look::plain))
        view = with_more_light(std::move(view), {LightFrame::point, news.lamp});
    ImGui::SameLine();
    if (draw_button("remove light", "Remove", Look::plain)) view = with_less_light(std::move(view));
    explain("A light or lamp can be dragged by its disc in the picture.");
}

}  // namespace scanlight::apps::window
