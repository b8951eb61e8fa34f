#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "apps/demo/screen.h"
#include "apps/scanlight/means.h"
#include "raster/project.h"

namespace scanlight::demo {

/// A number from `low` to `high`. `stops` of them, evenly spaced, are what a page shows, and what
/// frames are counted by; `start` is one of these.
struct Slider {
    double low = 0.0;
    double high = 1.0;
    int stops = 2;
    double start = 0.0;
    int digits = 0;  // after the point
};

/// One of some words; its value is the word's place among them, from 0.
struct Choice {
    std::vector<std::string> words;
    std::size_t start = 0;
};

/// A polygon in the plane z = 0, by its corners.
using Polygon = std::vector<glm::dvec2>;

/// The corners of a polygon, which a person drags in the picture. They start as the word of a
/// choice has them, a control that stands before this one.
struct Corners {
    std::string choice;
    std::vector<Polygon> starts;  // one for each of its words
    glm::dvec2 low, high;         // where a corner may be
    glm::dvec2 places_a_unit;     // a corner's x and y are whole multiples of 1 / these
};

/// How a page moves a control: by pictures drawn beforehand, one for each stop; through the
/// recorded steps of a `Screen`; or not at all, because it takes a person pointing in the window.
enum class Moved { by_pictures, by_steps, by_pointing };

/// Whether a place in a picture sets a control: to its share of the picture's width, or height.
enum class Pointed { nowhere, column, row };

struct Control {
    std::string name;    // on the command line
    std::string symbol;  // as the literature writes it; may be empty
    std::variant<Slider, Choice, Corners> kind;
    Moved moved = Moved::by_pictures;
    Pointed pointed = Pointed::nowhere;
};

/// Where a lesson's controls stand, by their names.
struct Settings {
    std::map<std::string, double> values;    // of sliders and choices
    std::map<std::string, Polygon> corners;  // that were moved; else they are where they start

    double at(const std::string& control) const { return values.at(control); }
    double& operator[](const std::string& control) { return values[control]; }
    bool operator==(const Settings&) const = default;
};

/// Where a lesson's matter lies in the source.
struct SourcePlace {
    std::string file;
    std::string function;
};

/// A file that the commands of a lesson read, and that the program brings along.
struct BroughtFile {
    std::string path;  // as the commands name it
    std::string_view content;
};

/// One screen of the course: a picture, its controls, and the numbers beside it. Its words are in
/// texts.toml, under its name. The window, the command line and the page all use the one `draw`.
struct Lesson {
    std::string name;
    std::vector<Control> controls;  // the first is the one that matters
    std::vector<SourcePlace> places;
    /// Each panel of `size`. `settings` has a value for each slider and choice. Throws UsageError
    /// or FileError for a polygon of which nothing can be drawn.
    Screen (*draw)(const Settings& settings, raster::Viewport size, const apps::Means& means);
    std::vector<BroughtFile> files{};
};

/// In the order of the course.
const std::vector<Lesson>& lessons();

/// Throws UsageError, which names them all, for a name that none has.
const Lesson& lesson_named(const std::string& name);

}  // namespace scanlight::demo
