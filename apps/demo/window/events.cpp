#include "apps/demo/window/events.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "apps/demo/window/camera_moves.h"
#include "apps/demo/window/light_handles.h"

namespace scanlight::apps::window {

namespace {

constexpr double handle_radius = 11.0;  // pixels
constexpr double divider_reach = 6.0;

const render::Camera& camera_of(View view, const Cameras& cameras) {
    return cameras[static_cast<std::size_t>(view)];
}

Pane pane_of(View view, const WindowState& state) {
    for (const Pane& pane : panes_of(state)) {
        if (pane.view == view) return pane;
    }
    return panes_of(state).front();
}

bool is_on_divider(const WindowState& state, Point at) {
    return has_divider(state) && std::abs(at.x - divider_column(state)) <= divider_reach;
}

std::optional<MovingLight> light_at(const WindowState& state, Point at, const Cameras& cameras) {
    const auto pane = pane_at(state, at);
    if (!pane || state.arrangement == Arrangement::difference) return std::nullopt;
    const auto handles =
        light_handles(state.of(pane->view), camera_of(pane->view, cameras), pane->picture);
    for (const LightHandle& handle : handles) {
        if (std::hypot(handle.at.x - at.x, handle.at.y - at.y) <= handle_radius)
            return MovingLight{pane->view, handle.light};
    }
    return std::nullopt;
}

/// The same change of the camera for both views.
template <class Change>
WindowState with_cameras(WindowState state, Change change) {
    for (SceneOptions& view : state.views)
        view = change(std::move(view));
    return state;
}

// ---- a press

Drag drag_from(const WindowState& state, const Press& press, const Cameras& cameras) {
    const auto pane = pane_at(state, press.at);
    if (!pane) return {};
    const render::Camera& camera = camera_of(pane->view, cameras);
    if (press.button != Button::left || press.is_shifted) return Panning{press.at, camera};
    if (const auto light = light_at(state, press.at, cameras)) return *light;
    if (is_on_divider(state, press.at)) return MovingDivider{};
    return Turning{press.at, camera};
}

WindowState pressed(WindowState state, const Press& press, const Cameras& cameras) {
    state.drag = drag_from(state, press, cameras);
    const auto pane = pane_at(state, press.at);
    if (pane && !std::holds_alternative<MovingDivider>(state.drag)) state.chosen = pane->view;
    return state;
}

// ---- a move, by what is dragged

Point between(Point from, Point to) {
    return {to.x - from.x, to.y - from.y};
}

WindowState dragged(WindowState state, std::monostate, Point, const Cameras&) {
    return state;
}

WindowState dragged(WindowState state, const Turning& drag, Point to, const Cameras&) {
    return with_cameras(std::move(state), [&](SceneOptions view) {
        return turned(std::move(view), drag.camera, between(drag.from, to));
    });
}

WindowState dragged(WindowState state, const Panning& drag, Point to, const Cameras&) {
    const int height = state.canvas.height;
    return with_cameras(std::move(state), [&](SceneOptions view) {
        return panned(std::move(view), drag.camera, between(drag.from, to), height);
    });
}

WindowState dragged(WindowState state, MovingDivider, Point to, const Cameras&) {
    state.divider = std::clamp(to.x / state.canvas.width, 0.0, 1.0);
    return on_canvas(std::move(state), state.canvas);
}

WindowState dragged(WindowState state, const MovingLight& drag, Point to, const Cameras& cameras) {
    const Pane pane = pane_of(drag.view, state);
    state.of(drag.view) = with_light_at(std::move(state.of(drag.view)), drag.light, to,
                                        camera_of(drag.view, cameras), pane.picture);
    return state;
}

// ---- keys

WindowState after_key(WindowState state, char letter) {
    switch (letter) {
        case '1':
            return arranged(std::move(state), Arrangement::one);
        case '2':
            return arranged(std::move(state), Arrangement::wipe);
        case '3':
            return arranged(std::move(state), Arrangement::beside);
        case '4':
            return arranged(std::move(state), Arrangement::difference);
        case '\t':
            state.chosen = other(state.chosen);
            return state;
        case 'f':
            return framed(std::move(state), render::ViewAngles{});
        case 'l':
            state.loupe = state.loupe == Loupe::open ? Loupe::closed : Loupe::open;
            return state;
        case 'p':
            state.picked = state.picked ? std::nullopt : state.mouse;
            return state;
        case 'c':
            return about(std::move(state), Subject::lesson);
        default:
            return state;
    }
}

// ---- events

struct After {
    WindowState state;
    const Cameras& cameras;

    WindowState operator()(const Press& press) { return pressed(std::move(state), press, cameras); }
    WindowState operator()(const Move& move) {
        state.mouse = move.to;
        const Drag drag = state.drag;
        return std::visit(
            [&](const auto& what) { return dragged(std::move(state), what, move.to, cameras); },
            drag);
    }
    WindowState operator()(Release) {
        state.drag = {};
        return std::move(state);
    }
    WindowState operator()(Leave) {
        state.mouse.reset();
        return std::move(state);
    }
    WindowState operator()(const Wheel& wheel) {
        return with_cameras(std::move(state), [&](SceneOptions view) {
            return zoomed(std::move(view), wheel.notches);
        });
    }
    WindowState operator()(const Key& key) { return after_key(std::move(state), key.letter); }
    WindowState operator()(const Nudge&) { return std::move(state); }
    WindowState operator()(NamedKey) { return std::move(state); }
};

}  // namespace

WindowState after(WindowState state, const Event& event, const Cameras& cameras) {
    return std::visit(After{std::move(state), cameras}, event);
}

Target target_at(const WindowState& state, Point point, const Cameras& cameras) {
    if (light_at(state, point, cameras)) return Target::light;
    if (is_on_divider(state, point)) return Target::divider;
    return pane_at(state, point) ? Target::picture : Target::nothing;
}

}  // namespace scanlight::apps::window
