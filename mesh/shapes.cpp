#include "mesh/shapes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "mesh/corner_text.h"
#include "mesh/file_error.h"
#include "mesh/flat_shapes.h"
#include "mesh/round_shapes.h"
#include "mesh/solids.h"
#include "mesh/teapot.h"
#include "mesh/text.h"

namespace scanlight::mesh {
namespace {

struct Parameter {
    std::string_view name;
    std::uint32_t low, high, usual;
};

using Numbers = std::array<std::uint32_t, 2>;

std::string described(const Parameter& parameter) {
    return std::string(parameter.name) + " (" + std::to_string(parameter.low) + " to " +
           std::to_string(parameter.high) + ", default " + std::to_string(parameter.usual) + ")";
}

std::string described(const std::vector<Parameter>& parameters) {
    std::string text;
    for (const Parameter& parameter : parameters) {
        text += (text.empty() ? "" : ", ") + described(parameter);
    }
    return text;
}

std::uint32_t number(std::string_view text, const Parameter& parameter, std::string_view shape) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (whole && value >= parameter.low && value <= parameter.high) return value;
    throw FileError("shape " + std::string(shape) + ": '" + std::string(text) + "' can't be its " +
                    described(parameter));
}

Numbers numbers_for(const std::vector<Parameter>& parameters,
                    std::span<const std::string_view> given, std::string_view shape) {
    if (given.size() > parameters.size()) {
        throw FileError("shape " + std::string(shape) + " takes " +
                        (parameters.empty() ? "no parameters" : "only " + described(parameters)));
    }
    Numbers numbers{};
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Parameter& parameter = parameters[i];
        numbers[i] = i < given.size() ? number(given[i], parameter, shape) : parameter.usual;
    }
    return numbers;
}

/// What stands after a shape's name; none if nothing does.
using Given = std::optional<std::string_view>;

struct Kind {
    std::string_view name;
    std::string parameters;  // for a person
    std::function<PolygonSoup(const Given&)> make;
};

/// A shape whose parameters are whole numbers.
Kind by_numbers(std::string_view name, const std::vector<Parameter>& parameters,
                PolygonSoup (*make)(const Numbers&)) {
    return {name, described(parameters), [=](const Given& given) {
                const auto pieces = given ? split(*given, ',') : std::vector<std::string_view>{};
                return make(numbers_for(parameters, pieces, name));
            }};
}

/// A shape whose parameters are its corners.
Kind by_corners(std::string_view name, std::string_view usual) {
    const std::string parameters = "X,Y:X,Y:... (3 to " + std::to_string(most_corners) +
                                   " corners, default " + std::string(usual) + ")";
    return {
        name, parameters, [=](const Given& given) {
            return flat_polygon(parse_corners(given.value_or(usual), "shape " + std::string(name)));
        }};
}

// The bounds keep every shape below some 4 million faces.
const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        by_numbers("cube", {}, [](const Numbers&) { return cube(); }),
        by_numbers("tetrahedron", {}, [](const Numbers&) { return tetrahedron(); }),
        by_numbers("octahedron", {}, [](const Numbers&) { return octahedron(); }),
        by_numbers("icosphere", {{"level", 0, 8, 3}},
                   [](const Numbers& p) { return icosphere(p[0]); }),
        by_numbers("sphere", {{"slices", 3, 2048, 48}, {"stacks", 2, 2048, 24}},
                   [](const Numbers& p) { return uv_sphere(p[0], p[1]); }),
        by_numbers("wavy-sphere", {{"slices", 3, 2048, 256}, {"stacks", 2, 2048, 128}},
                   [](const Numbers& p) { return wavy_sphere(p[0], p[1]); }),
        by_numbers("torus", {{"segments", 3, 2048, 48}, {"sides", 3, 2048, 24}},
                   [](const Numbers& p) { return torus(p[0], p[1]); }),
        by_numbers("cylinder", {{"segments", 3, 100000, 48}},
                   [](const Numbers& p) { return cylinder(p[0]); }),
        by_numbers("cone", {{"segments", 3, 100000, 48}},
                   [](const Numbers& p) { return cone(p[0]); }),
        by_numbers("plane", {{"n", 1, 2048, 8}}, [](const Numbers& p) { return plane(p[0]); }),
        by_numbers("ngon", {{"n", 3, 100000, 6}},
                   [](const Numbers& p) { return regular_polygon(p[0]); }),
        by_numbers("star", {{"points", 3, 50000, 5}}, [](const Numbers& p) { return star(p[0]); }),
        by_corners("polygon", "0,1:-0.8,-0.8:0,-0.3:0.8,-0.8"),
        by_numbers("teapot", {{"n", 2, 256, 8}}, [](const Numbers& p) { return teapot(p[0]); }),
    };
    return all;
}

std::string_view name_in(std::string_view text) {
    return text.substr(0, text.find(':'));
}

const Kind* find_kind(std::string_view name) {
    const auto found = std::ranges::find(kinds(), name, &Kind::name);
    return found == kinds().end() ? nullptr : &*found;
}

const Kind& kind_named(std::string_view name) {
    if (const Kind* kind = find_kind(name)) return *kind;
    const auto nearest = std::ranges::min_element(kinds(), {}, [&](const Kind& kind) {
        return edit_distance(name.substr(0, 64), kind.name);
    });
    throw FileError("no shape is named '" + std::string(name) + "'; the nearest is '" +
                    std::string(nearest->name) + "'");
}

}  // namespace

std::vector<ShapeInfo> list_shapes() {
    std::vector<ShapeInfo> shapes;
    for (const Kind& kind : kinds()) {
        shapes.push_back({std::string(kind.name), kind.parameters});
    }
    return shapes;
}

bool is_shape(std::string_view text) {
    return find_kind(name_in(text)) != nullptr;
}

PolygonSoup shape(std::string_view text) {
    const std::string_view name = name_in(text);
    const bool is_all = name.size() == text.size();
    return kind_named(name).make(is_all ? Given() : text.substr(name.size() + 1));
}

}  // namespace scanlight::mesh
