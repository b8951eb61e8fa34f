#pragma once

#include <map>
#include <string>
#include <vector>

#include "apps/demo/window/contrast.h"
#include "apps/demo/window/parameters.h"
#include "apps/demo/window/state.h"

namespace scanlight::apps::window {

/// What a person asks for beside a change of the state.
enum class Wish { nothing, save_picture, save_scene, copy_command_line };

/// What the panel tells.
struct PanelNews {
    std::size_t polygons = 0;
    std::string message;  // what was done last, or went wrong
    double picture_milliseconds = 0.0;
    shading::Material<float> material;  // of the first surface
    glm::dvec3 lamp{0.0};               // where a new lamp is to stand
};

/// The controls beside the picture: a row for each parameter that the picture knows.
class Panel {
public:
    static constexpr int width = 388;  // pixels

    Panel();

    struct Result {
        WindowState state;
        Wish wish = Wish::nothing;
    };
    /// Between two calls of Gui: draws it into columns [x, x + width) of the window.
    Result draw(WindowState state, const PanelNews& news, int x, int height);

    /// Where each control of the last frame stood in the window, by its name.
    const std::map<std::string, Box>& places() const { return places_; }

private:
    enum class Look { plain, chosen };

    void draw_arrangements(WindowState& state);
    void draw_views(WindowState& state);
    void draw_shapes(WindowState& state);
    void draw_parameters(WindowState& state, const PanelNews& news);
    void draw_lights(WindowState& state, const PanelNews& news);
    void draw_light_buttons(WindowState& state, const PanelNews& news);
    Wish draw_wishes();
    bool begin_group(const std::string& group);
    void draw_row(WindowState& state, const Parameter& parameter, const PanelNews& news);
    bool draw_button(const std::string& name, const std::string& label, Look look);
    void note_place(const std::string& name);

    std::vector<std::string> shapes_;
    std::vector<Parameter> parameters_;
    std::vector<std::vector<Parameter>> of_lights_;
    std::map<std::string, Box> places_;
};

}  // namespace scanlight::apps::window
