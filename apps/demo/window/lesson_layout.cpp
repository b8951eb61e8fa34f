#include "apps/demo/window/lesson_layout.h"

#include <algorithm>
#include <utility>

namespace scanlight::apps::window {

namespace {

constexpr int gap = 12;  // pixels
constexpr int least_side = 24;
constexpr std::size_t most_plots_in_a_row = 3;
constexpr double highest_plot = 0.8;  // of its width

/// Rows and columns of equal cells.
struct Cells {
    int columns = 1;
    int width = 0;
    int height = 0;  // without what is above it
};

/// The form of a cell, and the room that it needs above.
struct Form {
    double width_by_height = 1.0;
    int above = 0;
};

int cell_width(int columns, int count, const Box& room, const Form& form) {
    const int rows = (count + columns - 1) / columns;
    const int width = (room.width - gap * (columns - 1)) / columns;
    const int height = (room.height - gap * (rows - 1)) / rows - form.above;
    return std::max(least_side, std::min(width, static_cast<int>(height * form.width_by_height)));
}

/// As many columns as make the cells largest.
Cells largest_cells(int count, const Box& room, const Form& form) {
    Cells best;
    for (int columns = 1; columns <= count; ++columns) {
        const int width = cell_width(columns, count, room, form);
        if (width > best.width)
            best = {columns, width, static_cast<int>(width / form.width_by_height)};
    }
    return best;
}

/// In rows from the upper left corner of the room.
std::vector<Box> placed(std::size_t count, const Cells& cells, const Box& room, int above) {
    std::vector<Box> boxes;
    for (int i = 0; i < static_cast<int>(count); ++i) {
        const int x = room.x + i % cells.columns * (cells.width + gap);
        const int y = room.y + i / cells.columns * (cells.height + above + gap) + above;
        boxes.push_back({x, y, cells.width, cells.height});
    }
    return boxes;
}

/// Made as wide as there is room, and as high as that allows.
Cells stretched(Cells cells, int count, const Box& room, const Form& form) {
    const int rows = (count + cells.columns - 1) / cells.columns;
    cells.width = (room.width - gap * (cells.columns - 1)) / cells.columns;
    cells.height = std::min((room.height - gap * (rows - 1)) / rows - form.above,
                            static_cast<int>(cells.width * highest_plot));
    return cells;
}

std::vector<Box> panel_boxes(const LessonShape& shape, const Box& room) {
    const Form form{shape.walks > 0 ? 3.0 / 2.0 : 4.0 / 3.0, caption_height};
    const Cells cells = largest_cells(static_cast<int>(shape.panels), room, form);
    return placed(shape.panels, cells, room, form.above);
}

std::vector<Box> plot_boxes(const LessonShape& shape, const Box& room) {
    const Form form{1.8, caption_height};
    const int count = static_cast<int>(shape.plots);
    const Cells cells = stretched(largest_cells(count, room, form), count, room, form);
    return placed(shape.plots, cells, room, form.above);
}

/// Of the canvas' height, for what stands below the pictures.
double share_below(const LessonShape& shape) {
    const auto count = static_cast<int>(shape.plots + shape.tables);
    if (shape.plots > most_plots_in_a_row) return 0.62;
    return count == 0 ? 0.0 : 0.32 + 0.04 * count;
}

/// What is left of a row of the canvas.
Box beside(const Box& box, const Box& all) {
    const int x = box.x + box.width + gap;
    return {x, box.y, std::max(0, all.x + all.width - x), box.height};
}

Box inside(raster::Viewport canvas) {
    return {gap, 0, canvas.width - 2 * gap, canvas.height - gap};
}

/// The rest is what the pictures leave.
LessonLayout with_rest(LessonLayout layout, const LessonShape& shape, Box room) {
    if (shape.tables > 0 && shape.plots > 0) room.width /= 2;
    if (shape.plots > 0) layout.plots = plot_boxes(shape, room);
    layout.tables = room;
    if (shape.plots > 0) layout.tables.x += room.width;
    return layout;
}

LessonLayout with_rest_below(const LessonShape& shape, const Box& all) {
    Box above = all;
    above.height -= static_cast<int>(all.height * share_below(shape));
    LessonLayout layout;
    layout.panels = panel_boxes(shape, above);
    if (shape.walks > 0) layout.code = beside(layout.panels.back(), all);
    const int y = layout.panels.back().y + layout.panels.back().height + gap;
    return with_rest(std::move(layout), shape, {all.x, y, all.width, all.y + all.height - y});
}

LessonLayout with_rest_beside(const LessonShape& shape, const Box& all) {
    Box before = all;
    before.width = all.width * 3 / 5;
    LessonLayout layout;
    layout.panels = panel_boxes(shape, before);
    const auto right = [](const Box& box) { return box.x + box.width; };
    const Box& last = *std::ranges::max_element(layout.panels, {}, right);
    const Box rest = beside(last, all);
    const int y = shape.plots > 0 ? all.y : all.y + caption_height;
    return with_rest(std::move(layout), shape, {rest.x, y, rest.width, all.y + all.height - y});
}

}  // namespace

LessonShape shape_of(const demo::Screen& screen) {
    return {screen.panels.size(), screen.plots.size(), screen.tables.size(),
            screen.walked ? std::size_t{1} : std::size_t{0}};
}

LessonLayout layout_of(const LessonShape& shape, raster::Viewport canvas) {
    const Box all = inside(canvas);
    LessonLayout layout = with_rest_below(shape, all);
    if (shape.plots + shape.tables != 1 || shape.walks > 0) return layout;
    LessonLayout other = with_rest_beside(shape, all);
    return other.panels.front().width > layout.panels.front().width ? other : layout;
}

}  // namespace scanlight::apps::window
