#include "mesh/shapes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <span>

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

struct Kind {
    std::string_view name;
    std::vector<Parameter> parameters;
    PolygonSoup (*make)(const Numbers&);
};

// The bounds keep every shape below some 4 million faces.
const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {"cube", {}, [](const Numbers&) { return cube(); }},
        {"tetrahedron", {}, [](const Numbers&) { return tetrahedron(); }},
        {"octahedron", {}, [](const Numbers&) { return octahedron(); }},
        {"icosphere", {{"level", 0, 8, 3}}, [](const Numbers& p) { return icosphere(p[0]); }},
        {"sphere",
         {{"slices", 3, 2048, 48}, {"stacks", 2, 2048, 24}},
         [](const Numbers& p) { return uv_sphere(p[0], p[1]); }},
        {"wavy-sphere",
         {{"slices", 3, 2048, 256}, {"stacks", 2, 2048, 128}},
         [](const Numbers& p) { return wavy_sphere(p[0], p[1]); }},
        {"torus",
         {{"segments", 3, 2048, 48}, {"sides", 3, 2048, 24}},
         [](const Numbers& p) { return torus(p[0], p[1]); }},
        {"cylinder",
         {{"segments", 3, 100000, 48}},
         [](const Numbers& p) { return cylinder(p[0]); }},
        {"cone", {{"segments", 3, 100000, 48}}, [](const Numbers& p) { return cone(p[0]); }},
        {"plane", {{"n", 1, 2048, 8}}, [](const Numbers& p) { return plane(p[0]); }},
        {"ngon", {{"n", 3, 100000, 6}}, [](const Numbers& p) { return regular_polygon(p[0]); }},
        {"star", {{"points", 3, 50000, 5}}, [](const Numbers& p) { return star(p[0]); }},
        {"teapot", {{"n", 2, 256, 8}}, [](const Numbers& p) { return teapot(p[0]); }},
    };
    return all;
}

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

/// The pieces between commas, one at least.
std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> pieces;
    for (std::size_t comma = text.find(','); comma != std::string_view::npos;
         comma = text.find(',')) {
        pieces.push_back(text.substr(0, comma));
        text.remove_prefix(comma + 1);
    }
    pieces.push_back(text);
    return pieces;
}

std::uint32_t number(std::string_view text, const Parameter& parameter, std::string_view shape) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (whole && value >= parameter.low && value <= parameter.high) return value;
    throw FileError("shape " + std::string(shape) + ": '" + std::string(text) + "' can't be its " +
                    described(parameter));
}

Numbers numbers_for(const Kind& kind, std::span<const std::string_view> given) {
    if (given.size() > kind.parameters.size()) {
        throw FileError(
            "shape " + std::string(kind.name) + " takes " +
            (kind.parameters.empty() ? "no parameters" : "only " + described(kind.parameters)));
    }
    Numbers numbers{};
    for (std::size_t i = 0; i < kind.parameters.size(); ++i) {
        const Parameter& parameter = kind.parameters[i];
        numbers[i] = i < given.size() ? number(given[i], parameter, kind.name) : parameter.usual;
    }
    return numbers;
}

}  // namespace

std::vector<ShapeInfo> list_shapes() {
    std::vector<ShapeInfo> shapes;
    for (const Kind& kind : kinds()) {
        shapes.push_back({std::string(kind.name), described(kind.parameters)});
    }
    return shapes;
}

bool is_shape(std::string_view text) {
    return find_kind(name_in(text)) != nullptr;
}

PolygonSoup shape(std::string_view text) {
    const std::string_view name = name_in(text);
    const Kind& kind = kind_named(name);
    const std::vector<std::string_view> given = name.size() == text.size()
                                                    ? std::vector<std::string_view>{}
                                                    : split(text.substr(name.size() + 1));
    return kind.make(numbers_for(kind, given));
}

}  // namespace scanlight::mesh
