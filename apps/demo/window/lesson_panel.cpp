#include "apps/demo/window/lesson_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/demo/settings.h"
#include "apps/demo/window/control.h"
#include "apps/demo/window/corner_handles.h"
#include "apps/demo/window/course_list.h"
#include "apps/demo/window/formula_draw.h"
#include "apps/demo/window/gui.h"
#include "apps/demo/window/paragraph.h"
#include "apps/scanlight/text_table.h"

namespace scanlight::apps::window {

namespace {

constexpr float message_height = 62.0f;
constexpr float list_width = 292.0f;
constexpr float value_column = 88.0f;

const std::string& word(const LessonState& lesson, const std::string& key) {
    return demo::texts().of(lesson.lesson().name, key, lesson.language);
}

const std::string& page_word(const LessonState& lesson, const std::string& key) {
    return demo::texts().of("page", key, lesson.language);
}

void draw_text(const std::string& text) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void draw_quiet(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    draw_text(text);
    ImGui::PopStyleColor();
}

void explain(const std::string& text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
}

void draw_heading(const std::string& text) {
    ImGui::Spacing();
    ImGui::Separator();
    draw_quiet(text);
}

void begin_window(int x, int height) {
    ImGui::SetNextWindowPos({static_cast<float>(x), 0.0f});
    ImGui::SetNextWindowSize({static_cast<float>(Panel::width), static_cast<float>(height)});
    ImGui::Begin("lesson", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
}

// ---- controls

void draw_label(const LessonState& lesson, const demo::Control& control) {
    if (!control.symbol.empty()) {
        draw_symbol(control.symbol);
        ImGui::SameLine(0.0f, 10.0f);
    }
    draw_quiet(word(lesson, "control-" + control.name));
}

LessonState draw_slider(LessonState lesson, const demo::Control& control,
                        const demo::Screen& screen) {
    const auto& slider = std::get<demo::Slider>(control.kind);
    const double low = slider.low;
    const double high = last_value(control, screen);
    double value = std::min(lesson.settings.at(control.name), high);
    const std::string format = "%." + std::to_string(slider.digits) + "f";
    if (ImGui::SliderScalar(("##" + control.name).c_str(), ImGuiDataType_Double, &value, &low,
                            &high, format.c_str()))
        lesson = with_control(std::move(lesson), control, value);
    return lesson;
}

LessonState draw_choice(LessonState lesson, const demo::Control& control) {
    const auto& words = std::get<demo::Choice>(control.kind).words;
    const auto at = static_cast<std::size_t>(lesson.settings.at(control.name));
    const std::string shown = word(lesson, "word-" + words[at]);
    if (!ImGui::BeginCombo(("##" + control.name).c_str(), shown.c_str())) return lesson;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (ImGui::Selectable(word(lesson, "word-" + words[i]).c_str(), i == at))
            lesson = with_control(std::move(lesson), control, static_cast<double>(i));
    }
    ImGui::EndCombo();
    return lesson;
}

/// A slider or a choice.
LessonState draw_control(LessonState lesson, const demo::Control& control,
                         const demo::Screen& screen) {
    ImGui::SetNextItemWidth(-1.0f);
    return std::holds_alternative<demo::Slider>(control.kind)
               ? draw_slider(std::move(lesson), control, screen)
               : draw_choice(std::move(lesson), control);
}

/// "x, y": the controls that a place in a picture sets; empty if none.
std::string pointed_controls(const LessonState& lesson) {
    std::string names;
    for (const demo::Control& control : lesson.lesson().controls) {
        if (control.pointed != demo::Pointed::nowhere)
            names += (names.empty() ? "" : ", ") + control.symbol;
    }
    return names;
}

void draw_hint(const LessonState& lesson) {
    const std::string names = pointed_controls(lesson);
    if (names.empty()) return;
    std::string hint = page_word(lesson, "point");
    hint.replace(hint.find("{0}"), 3, names);
    draw_quiet(hint);
}

// ---- what it says

void draw_number(const LessonState& lesson, const demo::Number& number) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    draw_quiet(word(lesson, number.key));
    ImGui::TableNextColumn();
    const std::string unit = number.unit.empty() ? "" : " " + number.unit;
    ImGui::TextUnformatted((fixed(number.value, number.digits) + unit).c_str());
}

void draw_numbers(const LessonState& lesson, const demo::Screen& screen) {
    if (screen.numbers.empty() || !ImGui::BeginTable("numbers", 2)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, value_column);
    for (const demo::Number& number : screen.numbers)
        draw_number(lesson, number);
    ImGui::EndTable();
}

/// With what its letters mean, and what some lessons add.
void draw_formula_of(const LessonState& lesson) {
    const std::string& name = lesson.lesson().name;
    draw_heading(page_word(lesson, "formula-head"));
    draw_formula(demo::texts().chapters().at(name).formula);
    for (const char* key : {"letters", "remark"}) {
        if (const auto* text = demo::texts().find(name, key, lesson.language))
            draw_paragraph(*text);
    }
}

void draw_places(const LessonState& lesson) {
    draw_heading(page_word(lesson, "source-head"));
    for (const auto& [file, function] : lesson.lesson().places)
        draw_text(file + "   " + function);
}

void draw_message(const LessonState& lesson, const std::string& message) {
    ImGui::Separator();
    draw_quiet(message.empty() ? page_word(lesson, "lesson-keys") : message);
}

}  // namespace

LessonPanel::Result LessonPanel::draw(WindowState state, const LessonSight& sight,
                                      const std::string& message, int x, int height) {
    places_.clear();
    begin_window(x, height);
    const std::size_t place = state.lesson.place;
    state = draw_course_list(std::move(state), list_width, places_);
    ImGui::SameLine();
    state = draw_language(std::move(state), places_);
    Result result;
    result.wish = draw_ways(state);
    ImGui::BeginChild("words", {0.0f, -message_height});
    if (state.lesson.place == place) {  // else what is seen is another lesson's
        LessonState& lesson = state.lesson;
        draw_controls(lesson, sight);
        note_corners(lesson, sight);
        draw_numbers(lesson, sight.screen);
        draw_heading(word(lesson, "title"));
        draw_text(word(lesson, "intro"));
        draw_heading(page_word(lesson, "notice-head"));
        draw_text(word(lesson, "notice"));
        draw_question(lesson);
        draw_formula_of(lesson);
        draw_places(lesson);
        result.to_copy = draw_commands(lesson, sight);
    }
    ImGui::EndChild();
    draw_message(state.lesson, message);
    ImGui::End();
    result.state = std::move(state);
    return result;
}

bool LessonPanel::draw_button(const std::string& name, const std::string& label) {
    const bool is_pressed = ImGui::Button((label + "##" + name).c_str());
    places_[name] = place_of_item();
    return is_pressed;
}

/// To the lessons beside it, and out of the course.
Wish LessonPanel::draw_ways(WindowState& state) {
    if (draw_button("previous", "\xE2\x86\x90"))
        state.lesson = with_previous(std::move(state.lesson));
    explain(page_word(state.lesson, "previous"));
    ImGui::SameLine();
    if (draw_button("next", "\xE2\x86\x92")) state.lesson = with_next(std::move(state.lesson));
    explain(page_word(state.lesson, "next"));
    ImGui::SameLine();
    if (draw_button("free view", page_word(state.lesson, "free-view")))
        state = about(std::move(state), Subject::scene);
    ImGui::SameLine();
    const bool is_saved = draw_button("save picture", page_word(state.lesson, "save-picture"));
    return is_saved ? Wish::save_picture : Wish::nothing;
}

void LessonPanel::draw_controls(LessonState& lesson, const LessonSight& sight) {
    for (const demo::Control& control : lesson.lesson().controls) {
        draw_label(lesson, control);
        if (std::holds_alternative<demo::Corners>(control.kind)) {
            draw_corners(lesson, control);
            continue;
        }
        lesson = draw_control(std::move(lesson), control, sight.screen);
        places_[control.name] = place_of_item();
        if (control.moved == demo::Moved::by_steps) draw_steps(lesson, sight.screen);
    }
    draw_hint(lesson);
    ImGui::Spacing();
}

/// They are dragged in the picture; here they are told, and put back.
void LessonPanel::draw_corners(LessonState& lesson, const demo::Control& control) {
    ImGui::PushFont(small_font());
    draw_text(demo::text_of(control, lesson.settings));
    ImGui::PopFont();
    ImGui::BeginDisabled(!lesson.settings.corners.contains(control.name));
    if (draw_button("put back", page_word(lesson, "put-back")))
        lesson = with_corners_back(std::move(lesson), control);
    ImGui::EndDisabled();
    draw_quiet(page_word(lesson, "drag-corners"));
}

void LessonPanel::note_corners(const LessonState& lesson, const LessonSight& sight) {
    const auto corners = corner_places(lesson, sight);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto x = static_cast<int>(std::lround(corners[i].x));
        const auto y = static_cast<int>(std::lround(corners[i].y));
        places_["corner " + std::to_string(i)] = {x, y, 1, 1};
    }
}

/// Six buttons in two rows.
void LessonPanel::draw_steps(LessonState& lesson, const demo::Screen& screen) {
    constexpr std::pair<Way, const char*> buttons[] = {{Way::first, "first-step"},
                                                       {Way::scanline_back, "back-scanline"},
                                                       {Way::back, "back-step"},
                                                       {Way::forward, "next-step"},
                                                       {Way::scanline_forward, "next-scanline"},
                                                       {Way::last, "last-step"}};
    for (const auto& [way, key] : buttons) {
        if (draw_button(key, page_word(lesson, key)))
            lesson = moved(std::move(lesson), way, screen);
        if (way != Way::back && way != Way::last) ImGui::SameLine();
    }
}

void LessonPanel::draw_question(LessonState& lesson) {
    draw_heading(page_word(lesson, "question-head"));
    draw_text(word(lesson, "question"));
    const bool is_shown = lesson.answer == Answer::shown;
    if (draw_button("answer", page_word(lesson, is_shown ? "hide-answer" : "show-answer")))
        lesson = with_answer_turned(std::move(lesson));
    if (is_shown) draw_text(word(lesson, "answer"));
}

/// The screen's own, and those of its pictures.
std::string LessonPanel::draw_commands(const LessonState& lesson, const LessonSight& sight) {
    draw_heading(page_word(lesson, "command-head"));
    std::vector<std::string> commands{command_of(as_shown(lesson, sight.screen), sight.panel)};
    for (const demo::Panel& panel : sight.screen.panels)
        commands.push_back(panel.command);
    std::string to_copy;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (draw_button("copy " + std::to_string(i), page_word(lesson, "copy")))
            to_copy = commands[i];
        ImGui::SameLine();
        ImGui::PushFont(small_font());
        draw_text(commands[i]);
        ImGui::PopFont();
    }
    return to_copy;
}

}  // namespace scanlight::apps::window
