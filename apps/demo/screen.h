#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "raster/image.h"
#include "render/steps.h"

namespace scanlight::demo {

// What a lesson shows. Each `key` names a text of the lesson, or of all lessons.

/// A line drawn over a picture, in pixels; of length 0 it is a small circle round a pixel.
struct Mark {
    glm::dvec2 from, to;
};

struct Panel {
    std::string key;
    raster::Image8 picture;
    std::string command;  // which draws the picture, without the marks
    std::vector<Mark> marks{};
};

/// A number that the engine found.
struct Number {
    std::string key;
    double value = 0.0;
    int digits = 0;  // after the point
    std::string unit{};
};

struct Axis {
    std::string key;
    double low = 0.0;
    double high = 1.0;
};

struct Curve {
    std::string key;
    std::vector<glm::dvec2> points;  // at one that is not finite the curve breaks off
};

struct Plot {
    std::string key;
    Axis x, y;
    std::vector<Curve> curves;
    std::optional<double> here{};  // a place on the x axis: where the control stands
};

struct Table {
    std::string key;
    std::vector<std::string> columns;            // symbols; {{key}} is a text
    std::vector<std::vector<std::string>> rows;  // likewise
};

/// A polygon with the steps that the engine took, and the picture that they led to, pixel for
/// pixel.
struct Walked {
    render::PolygonSteps steps;
    raster::Image8 picture;
};

/// Where the corners of a control are in a panel, to be dragged.
struct Handles {
    std::string control;
    std::size_t panel = 0;
    glm::dmat3 picture_from_plane{1.0};  // pixels of its picture; homogeneous
};

struct Screen {
    std::vector<Panel> panels;
    std::vector<Number> numbers{};
    std::vector<Plot> plots{};
    std::vector<Table> tables{};
    std::optional<Walked> walked{};  // to be stepped through
    std::optional<Handles> handles{};
};

/// A panel's picture with its marks.
raster::Image8 marked(const Panel& panel);

/// The panels side by side, with their marks.
raster::Image8 picture_of(const Screen& screen);

}  // namespace scanlight::demo
