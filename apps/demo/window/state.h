#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/demo/window/box.h"
#include "apps/demo/window/lesson_state.h"
#include "apps/scene/scene_options.h"
#include "render/camera.h"

namespace scanlight::apps::window {

/// The two settings that are compared.
enum class View { left, right };

/// How they stand in the window: one alone; one picture on each side of the divider, as if a
/// curtain were drawn; each whole in its own part; or what is different between them.
enum class Arrangement { one, wipe, beside, difference };

/// What the window is about: a scene, seen freely, or a lesson of the course.
enum class Subject { scene, lesson };

/// Whether all that is known of a pixel is told.
enum class Loupe { closed, open };

// What the mouse has hold of. A drag is reckoned from where it began, so that it has no drift.

struct Turning {
    Point from;
    render::Camera camera;
};
struct Panning {
    Point from;
    render::Camera camera;
};
struct MovingDivider {};
struct MovingLight {
    View view = View::left;
    std::size_t light = 0;
};
using Drag = std::variant<std::monostate, Turning, Panning, MovingDivider, MovingLight>;

/// All that the window shows, as a value. What happens makes a new one of it: see `after`.
struct WindowState {
    std::array<SceneOptions, 2> views;
    Arrangement arrangement = Arrangement::one;
    View chosen = View::left;  // whose settings the panel shows
    double divider = 0.5;      // its place, as a share of the canvas' width
    raster::Viewport canvas{1280, 720};
    Drag drag;
    std::optional<Point> mouse;  // over the canvas
    Loupe loupe = Loupe::closed;
    std::optional<Point> picked;  // the pixel that the loupe holds; none: it follows the mouse
    Subject subject = Subject::scene;
    LessonState lesson = opened(0, demo::Language::english);  // that is shown, or was last

    SceneOptions& of(View view) { return views[static_cast<std::size_t>(view)]; }
    const SceneOptions& of(View view) const { return views[static_cast<std::size_t>(view)]; }
    SceneOptions& current() { return of(chosen); }
    const SceneOptions& current() const { return of(chosen); }
};

/// Where a view's picture stands, and what of it is seen.
struct Pane {
    View view = View::left;
    Box picture;
    Box visible;
};

/// Those that are to be drawn. A difference stands in the one pane of the chosen view.
std::vector<Pane> panes_of(const WindowState& state);

/// The pane with this pixel of the canvas; none outside of all.
std::optional<Pane> pane_at(const WindowState& state, Point point);

/// Column of the canvas, where two views share it.
int divider_column(const WindowState& state);
bool has_divider(const WindowState& state);

/// Both views begin as this scene. Its size is the canvas'.
WindowState window_of(const SceneOptions& scene);

/// The same in another arrangement or canvas; each view gets the size of its picture.
WindowState arranged(WindowState state, Arrangement arrangement);
WindowState on_canvas(WindowState state, raster::Viewport canvas);

/// Both views show what a person names: a mesh file, a built-in shape, or a scene file, which
/// brings its own settings; of the others' the window's stay. Throws FileError or UsageError.
WindowState with_input(WindowState state, const std::string& input);

/// Both views look from the side that is named, as far away as shows all.
WindowState framed(WindowState state, const render::ViewAngles& view);

/// What the window is about from now on; the mouse lets go of what it had hold of.
WindowState about(WindowState state, Subject subject);

/// Whether the mouse has hold of something.
bool is_dragging(const WindowState& state);

/// The lesson is what the window shows.
WindowState with_lesson(WindowState state, LessonState lesson);

/// The other view's settings become those of the chosen one.
WindowState with_other_alike(WindowState state);

constexpr View other(View view) {
    return view == View::left ? View::right : View::left;
}

}  // namespace scanlight::apps::window
