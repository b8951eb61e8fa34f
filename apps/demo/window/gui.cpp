#include "apps/demo/window/gui.h"

#include <imgui.h>

#include <filesystem>

#include "apps/demo/texts.h"
#include "apps/demo/window/gui_draw.h"

namespace scanlight::apps::window {

namespace {

constexpr float letter_height = 15.0f;
constexpr float subscript_height = 11.0f;
constexpr float small_height = 13.0f;

/// Debian's fonts-dejavu-core has the Greek that formulas need; ImGui's own font has not.
constexpr const char* usual_path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* chinese_path = "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf";

/// The letters of formulas, and those of all words of the course.
ImVector<ImWchar> letters() {
    static constexpr ImWchar usual[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027,
                                        0x2190, 0x21ff, 0x2200, 0x22ff, 0};
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(usual);
    for (const auto& [name, chapter] : demo::texts().chapters()) {
        builder.AddText(chapter.formula.c_str());
        for (const auto& words : {chapter.english, chapter.chinese}) {
            for (const auto& [key, text] : words)
                builder.AddText(text.c_str());
        }
    }
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    return ranges;
}

void add_font(ImFontAtlas& fonts, float height, const ImWchar* ranges) {
    ImFontConfig config;
    config.OversampleH = 1;
    config.PixelSnapH = true;  // letters are copied pixel for pixel
    if (!std::filesystem::exists(usual_path)) {
        fonts.AddFontDefault();
        return;
    }
    fonts.AddFontFromFileTTF(usual_path, height, &config, ranges);
    config.MergeMode = true;  // what the first has not is taken from the second
    if (has_chinese_letters()) fonts.AddFontFromFileTTF(chinese_path, height, &config, ranges);
}

void add_fonts(ImFontAtlas& fonts, const ImVector<ImWchar>& ranges) {
    for (const float height : {letter_height, subscript_height, small_height})
        add_font(fonts, height, ranges.Data);
}

void set_shapes(ImGuiStyle& style) {
    style.WindowRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding = 0.0f;
    style.WindowBorderSize = style.PopupBorderSize = 0.0f;
    style.WindowPadding = {14.0f, 12.0f};
    style.ItemSpacing = {8.0f, 5.0f};
    style.FramePadding = {7.0f, 3.0f};
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 9.0f;
    style.AntiAliasedLinesUseTex = false;
}

/// Quiet greys, so that the picture has the only colours, and one blue.
void set_colors(ImGuiStyle& style) {
    const ImVec4 blue(0.30f, 0.56f, 0.90f, 1.0f);
    const auto grey = [](float level) { return ImVec4(level, level, level * 1.04f, 1.0f); };
    auto& c = style.Colors;
    c[ImGuiCol_WindowBg] = grey(0.115f);
    c[ImGuiCol_PopupBg] = grey(0.15f);
    c[ImGuiCol_Text] = grey(0.90f);
    c[ImGuiCol_TextDisabled] = grey(0.56f);
    c[ImGuiCol_FrameBg] = grey(0.20f);
    c[ImGuiCol_FrameBgHovered] = grey(0.25f);
    c[ImGuiCol_FrameBgActive] = grey(0.29f);
    c[ImGuiCol_Button] = c[ImGuiCol_FrameBg];
    c[ImGuiCol_ButtonHovered] = grey(0.28f);
    c[ImGuiCol_ButtonActive] = blue;
    c[ImGuiCol_Header] = grey(0.165f);
    c[ImGuiCol_HeaderHovered] = grey(0.22f);
    c[ImGuiCol_HeaderActive] = grey(0.26f);
    c[ImGuiCol_SliderGrab] = c[ImGuiCol_CheckMark] = blue;
    c[ImGuiCol_SliderGrabActive] = ImVec4(0.45f, 0.68f, 0.98f, 1.0f);
    c[ImGuiCol_Separator] = grey(0.24f);
    c[ImGuiCol_ScrollbarBg] = grey(0.115f);
}

}  // namespace

void Gui::Delete::operator()(ImGuiContext* context) const {
    ImGui::DestroyContext(context);
}

Gui::Gui(SDL_Renderer* renderer) : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is left on anyone's disk
    io.BackendRendererName = "scanlight";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    const ImVector<ImWchar> ranges = letters();  // read until there is a texture
    add_fonts(*io.Fonts, ranges);
    set_shapes(ImGui::GetStyle());
    set_colors(ImGui::GetStyle());
    input_ = std::make_unique<GuiInput>();
    font_.reset(font_texture(renderer));
}

Gui::~Gui() = default;

void Gui::begin_frame(int width, int height, float seconds) {
    input_->begin_frame(width, height, seconds);
    ImGui::NewFrame();
}

void Gui::draw(SDL_Renderer* renderer) {
    ImGui::Render();
    draw_gui(*ImGui::GetDrawData(), renderer);
}

bool Gui::wants_mouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

bool Gui::wants_keys() const {
    return ImGui::GetIO().WantTextInput;
}

bool has_chinese_letters() {
    return std::filesystem::exists(chinese_path) && std::filesystem::exists(usual_path);
}

ImFont* small_font() {
    return ImGui::GetIO().Fonts->Fonts[2];
}

ImFont* subscript_font() {
    return ImGui::GetIO().Fonts->Fonts[1];
}

}  // namespace scanlight::apps::window
