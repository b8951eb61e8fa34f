#pragma once

namespace scanlight::apps::window {

/// In pixels of the canvas, from its upper left corner.
struct Point {
    double x = 0.0;
    double y = 0.0;
    bool operator==(const Point&) const = default;
};

/// Columns [x, x + width) and rows [y, y + height) of the canvas.
struct Box {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool holds(Point p) const {
        return p.x >= x && p.x < x + width && p.y >= y && p.y < y + height;
    }
    bool operator==(const Box&) const = default;
};

}  // namespace scanlight::apps::window
