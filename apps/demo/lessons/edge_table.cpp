#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "apps/demo/lessons.h"
#include "apps/demo/plane_in_picture.h"
#include "apps/demo/settings.h"
#include "apps/demo/stage.h"
#include "apps/demo/walk.h"
#include "apps/scanlight/label.h"
#include "apps/scanlight/steps_report.h"
#include "apps/scanlight/text_table.h"
#include "apps/scene/usage_error.h"
#include "mesh/corner_text.h"
#include "raster/develop.h"
#include "render/wireframe.h"

namespace scanlight::demo {

namespace {

using apps::fixed;
using raster::Trace;
using render::PolygonSteps;
using Row = std::vector<std::string>;

constexpr raster::Viewport grid{24, 16};
constexpr int most_steps = grid.width * grid.height + grid.height + int{mesh::most_corners};
constexpr apps::Color8 paper{247, 246, 242};
constexpr apps::Color8 grid_line{214, 210, 202};
constexpr apps::Color8 ink{26, 42, 96};

const std::vector<std::string> shadings{"gouraud", "phong", "flat"};

/// Before the camera below a unit is 5 pixels wide and 6 1/4 high, and the middle of the grid is
/// 0,0: corners stand at quarters of a pixel, and no nearer to the grid's rim than that.
Corners corners() {
    return {"polygon",
            {{{0.2, 1.12}, {-1.6, -0.76}, {1.5, -0.52}},
             {{0.1, 1.12}, {-1.7, 0.2}, {-0.1, -1.12}, {1.6, -0.28}},
             {{0.0, 1.12}, {-1.35, 0.36}, {-0.8, -0.92}, {0.8, -0.92}, {1.35, 0.36}},
             {{0.0, 1.12},
              {-0.35, 0.36},
              {-1.35, 0.36},
              {-0.55, -0.12},
              {-0.8, -0.92},
              {0.0, -0.44},
              {0.8, -0.92},
              {0.55, -0.12},
              {1.35, 0.36},
              {0.35, 0.36}}},
            {-2.35, -1.24},
            {2.35, 1.24},
            {20.0, 25.0}};
}

/// A camera that stays where it is, at the polygon's side, so that depth varies across it.
constexpr const char* camera =
    " --projection orthographic --eye 3,0,4 --target 0,0,0 --lens 46.875";

const Control& control_of_corners() {
    static const Control control{"corners", "", corners(), Moved::by_pointing};
    return control;
}

std::string arguments(const Settings& settings) {
    return "polygon:" + text_of(control_of_corners(), settings) + camera + " --shading " +
           word_of(shadings, settings, "shading") +
           " --perspective affine --material \"kd=0.6 ks=0.4 n=8\" --light point:-0.9,1,0.8";
}

/// Of the polygon, which crosses a scanline's centre at least.
PolygonSteps steps_of(const Stage& stage) {
    auto traced = render::trace_polygons(stage.scene(), stage.options().settings, grid);
    if (traced.empty() || traced.front().trace.edge_table.empty())
        throw apps::UsageError("corners: such a polygon crosses the centre of no scanline");
    return apps::with_grey_as_one(std::move(traced.front()));
}

// ---- the picture

/// Not 0 where a pixel has its colour already.
using StoredPixels = raster::Plane<std::uint8_t>;

/// Each pixel of the grid as a square, in the engine's own colours as far as they are stored.
raster::Image8 enlarged(const raster::Image8& picture, int cell, const StoredPixels& stored) {
    raster::Image8 large(grid.width * cell, grid.height * cell, 3);
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const auto pixel = picture.pixel(x, y);
            const bool shown = stored.at(x, y) != 0;
            const apps::Color8 color = shown ? apps::Color8{pixel[0], pixel[1], pixel[2]} : paper;
            apps::fill_box(large, x * cell, y * cell, cell, cell, grid_line);
            apps::fill_box(large, x * cell, y * cell, cell - 1, cell - 1, color);
        }
    }
    return large;
}

/// By the steps up to this one.
StoredPixels stored_pixels(const std::vector<WalkStep>& walk, std::size_t step,
                           const Trace& trace) {
    StoredPixels stored(grid, 0);
    for (std::size_t i = 0; i <= step; ++i) {
        if (walk[i].kind == WalkStep::Kind::pixel)
            stored.at(walk[i].x, trace.scanlines[walk[i].line].y) = 1;
    }
    return stored;
}

/// The polygon's outline, by the same camera over a finer grid.
void draw_outline(raster::Image8& large, const render::Scene& scene) {
    raster::Framebuffer lines({large.width(), large.height()}, raster::Rgba(0.0f));
    render::draw_wireframe(scene, {0.05f, 0.1f, 0.3f, 1.0f}, render::HiddenLines::shown, lines);
    const raster::Image8 drawn = raster::srgb_image(lines.color, raster::Alpha::kept);
    for (int y = 0; y < large.height(); ++y) {
        for (int x = 0; x < large.width(); ++x) {
            if (drawn.pixel(x, y)[3] != 0)
                std::ranges::copy(drawn.pixel(x, y).first(3), large.pixel(x, y).begin());
        }
    }
}

/// Right of a place and above it, and inside of the picture.
void write_beside(raster::Image8& picture, int x, int y, const std::string& text) {
    constexpr int height = 8;
    apps::write_text(picture, std::min(x, picture.width() - apps::text_width(text)),
                     std::max(0, y - height), text, ink);
}

/// Each corner as a square with its name, "P0" and so on.
void draw_corners(raster::Image8& large, const PolygonSteps& steps, int cell) {
    const int side = std::max(3, cell / 3);
    for (std::size_t i = 0; i < steps.corners.size(); ++i) {
        const int x = static_cast<int>(steps.corners[i].x * cell);
        const int y = static_cast<int>(steps.corners[i].y * cell);
        apps::fill_box(large, x - side / 2, y - side / 2, side, side, ink);
        write_beside(large, x + side, y, "P" + std::to_string(i));
    }
}

/// Where the active edges cross the scanline's centres, and the pixel that is stored.
std::vector<Mark> marks_of(const Trace& trace, const WalkStep& step, int cell) {
    if (step.kind == WalkStep::Kind::edge) return {};
    const auto& line = trace.scanlines[step.line];
    const double y = (line.y + 0.5) * cell;
    std::vector<Mark> marks{{{0.0, y}, {grid.width * cell - 1.0, y}}};
    for (const auto& edge : line.active)
        marks.push_back({{edge.x * cell, y - 0.4 * cell}, {edge.x * cell, y + 0.4 * cell}});
    if (step.kind == WalkStep::Kind::pixel)
        marks.push_back({{(step.x + 0.5) * cell, y}, {(step.x + 0.5) * cell, y}});
    return marks;
}

Panel panel_of_step(const Stage& stage, const PolygonSteps& steps,
                    const std::vector<WalkStep>& walk, std::size_t step, int cell,
                    const apps::Means& means) {
    raster::Image8 large =
        enlarged(stage.picture(means), cell, stored_pixels(walk, step, steps.trace));
    draw_outline(large, stage.scene());
    draw_corners(large, steps, cell);
    return {"grid", std::move(large),
            "scanlight steps " + stage.arguments() + " --size 24x16\n" + stage.command(),
            marks_of(steps.trace, walk[step], cell)};
}

// ---- the tables

std::vector<std::string> value_columns(const PolygonSteps& steps) {
    std::vector<std::string> columns;
    for (const std::string& name : steps.names) {
        columns.push_back(name);
        columns.push_back("Δ" + name);
    }
    columns.insert(columns.end(), {"z", "Δz"});
    return columns;
}

void append(Row& row, const Trace::Numbers& numbers) {
    for (std::size_t k = 0; k < numbers.values.size(); ++k) {
        row.push_back(fixed(numbers.values[k], 4));
        row.push_back(fixed(numbers.steps[k], 5));
    }
    row.push_back(fixed(numbers.z, 4));
    row.push_back(fixed(numbers.dz, 5));
}

std::string edge_name(const PolygonSteps& steps, const Trace::Edge& edge) {
    return "P" + std::to_string(edge.index) + "–P" +
           std::to_string((edge.index + 1) % steps.corners.size());
}

Row edge_row(const PolygonSteps& steps, const Trace::Edge& edge) {
    Row row{std::to_string(edge.y_begin), edge_name(steps, edge), std::to_string(edge.y_end - 1),
            fixed(edge.x, 3), fixed(edge.dx, 4)};
    append(row, edge);
    return row;
}

Table edges_table(const std::string& key, const PolygonSteps& steps,
                  const std::vector<Trace::Edge>& edges) {
    Table table{key, {"{{bucket}}", "{{edge}}", "y_max", "x", "Δx"}, {}};
    const auto values = value_columns(steps);
    table.columns.insert(table.columns.end(), values.begin(), values.end());
    for (const Trace::Edge& edge : edges)
        table.rows.push_back(edge_row(steps, edge));
    return table;
}

Table pixel_table(const PolygonSteps& steps, const WalkStep& step) {
    Table table{"pixel-table", {"x", "y"}, {}};
    const auto values = value_columns(steps);
    table.columns.insert(table.columns.end(), values.begin(), values.end());
    if (step.kind != WalkStep::Kind::pixel) return table;
    const auto& line = steps.trace.scanlines[step.line];
    Row row{std::to_string(step.x), std::to_string(line.y)};
    append(row, numbers_at(line.spans[step.span], step.x));
    table.rows.push_back(row);
    return table;
}

/// Those already entered; all, once the walk has begun.
std::vector<Trace::Edge> entered(const Trace& trace, const WalkStep& step) {
    const auto count = static_cast<std::ptrdiff_t>(step.edge) + 1;
    return {trace.edge_table.begin(), trace.edge_table.begin() + count};
}

std::vector<Trace::Edge> active(const Trace& trace, const WalkStep& step) {
    if (step.kind == WalkStep::Kind::edge) return {};
    return trace.scanlines[step.line].active;
}

Screen draw(const Settings& settings, raster::Viewport size, const apps::Means& means) {
    const Stage stage(arguments(settings), grid);
    PolygonSteps steps = steps_of(stage);
    const auto walk = walk_of(steps.trace);
    const auto at = std::min(static_cast<std::size_t>(settings.at("step")), walk.size() - 1);
    const int cell = std::max(2, size.width / grid.width);
    Screen screen{{panel_of_step(stage, steps, walk, at, cell, means)},
                  {{"step", static_cast<double>(at)},
                   {"steps", static_cast<double>(walk.size() - 1)},
                   {"scanlines", static_cast<double>(steps.trace.scanlines.size())}},
                  {},
                  {edges_table("edge-table", steps, entered(steps.trace, walk[at])),
                   edges_table("active-table", steps, active(steps.trace, walk[at])),
                   pixel_table(steps, walk[at])}};
    screen.walked = {std::move(steps), stage.picture(means)};
    screen.handles = {
        control_of_corners().name, 0,
        picture_from_plane(stage.scene().camera, {grid.width * cell, grid.height * cell})};
    return screen;
}

}  // namespace

Lesson edge_table_lesson() {
    return {"edge-table",
            {{"step", "", Slider{0, most_steps, most_steps + 1, 60}, Moved::by_steps},
             {"polygon", "", Choice{{"triangle", "quad", "pentagon", "star"}, 1}},
             control_of_corners(),
             {"shading", "", Choice{shadings}}},
            {{"raster/edge_table.h", "EdgeTable::build"},
             {"raster/scan_convert.h", "scan_convert"},
             {"raster/active_edges.h", "ActiveEdges::step"},
             {"raster/bilinear.h", "Bilinear::down"}},
            draw};
}

}  // namespace scanlight::demo
