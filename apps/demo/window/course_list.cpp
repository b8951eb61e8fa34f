#include "apps/demo/window/course_list.h"

#include <imgui.h>

#include <utility>

#include "apps/demo/window/control.h"
#include "apps/demo/window/gui.h"

namespace scanlight::apps::window {

namespace {

std::string page_word(const std::string& key, const WindowState& state) {
    return demo::texts().of("page", key, state.lesson.language);
}

/// "3. The lost highlight"
std::string title_of(std::size_t place, demo::Language language) {
    const std::string& name = demo::lessons()[place].name;
    return std::to_string(place + 1) + ". " + demo::texts().of(name, "title", language);
}

WindowState draw_entries(WindowState state) {
    if (ImGui::Selectable(page_word("free-view", state).c_str(), state.subject == Subject::scene))
        state = about(std::move(state), Subject::scene);
    for (std::size_t i = 0; i < demo::lessons().size(); ++i) {
        const bool is_shown = state.subject == Subject::lesson && state.lesson.place == i;
        if (ImGui::Selectable(title_of(i, state.lesson.language).c_str(), is_shown))
            state = with_lesson(std::move(state), opened(i, state.lesson.language));
    }
    return state;
}

/// Of the list while it is closed.
std::string label_of(const WindowState& state) {
    return state.subject == Subject::scene ? page_word("lessons", state)
                                           : title_of(state.lesson.place, state.lesson.language);
}

}  // namespace

WindowState draw_course_list(WindowState state, float width, std::map<std::string, Box>& places) {
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##lessons", label_of(state).c_str(), ImGuiComboFlags_HeightLargest)) {
        state = draw_entries(std::move(state));
        ImGui::EndCombo();
    }
    places["lessons"] = place_of_item();
    return state;
}

WindowState draw_language(WindowState state, std::map<std::string, Box>& places) {
    const bool is_english = state.lesson.language == demo::Language::english;
    const bool is_offered = !is_english || has_chinese_letters();
    const std::string label = is_offered ? page_word("language", state) : "Chinese";
    ImGui::BeginDisabled(!is_offered);
    if (ImGui::Button(label.c_str()))
        state.lesson.language = is_english ? demo::Language::chinese : demo::Language::english;
    ImGui::EndDisabled();
    places["language"] = place_of_item();
    if (!is_offered && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("Chinese needs letters: the package %s", chinese_package);
    return state;
}

}  // namespace scanlight::apps::window
