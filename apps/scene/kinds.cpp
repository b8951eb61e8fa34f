#include "apps/scene/kinds.h"

#include <algorithm>
#include <cmath>

#include "apps/scene/model.h"
#include "apps/scene/toml_number.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

using Folder = std::filesystem::path;

// As on the command line: beyond these nothing is meant.
constexpr double largest_coordinate = 1e30;
constexpr double largest_intensity = 1e6;
constexpr double largest_factor = 1e6;
constexpr double most_repeats = 1e4;
constexpr std::size_t longest_text = 200;
constexpr std::size_t longest_shape = 2000;  // a polygon names all its corners
constexpr std::size_t longest_path = 4096;
constexpr std::size_t most_turns = 16;

// ---- parts of values

std::optional<double> number_in(const Value& value, double low, double high) {
    const auto* integer = std::get_if<std::int64_t>(&value.is);
    const auto* number = std::get_if<double>(&value.is);
    if (integer == nullptr && number == nullptr) return std::nullopt;
    const double x = integer != nullptr ? static_cast<double>(*integer) : *number;
    return x >= low && x <= high ? std::optional(x) : std::nullopt;  // no NaN
}

/// `count` numbers.
std::optional<std::vector<double>> numbers_in(const Value& value, std::size_t count, double low,
                                              double high) {
    const auto* array = std::get_if<Array>(&value.is);
    if (array == nullptr || array->size() != count) return std::nullopt;
    std::vector<double> numbers;
    for (const Value& item : *array) {
        const auto number = number_in(item, low, high);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<glm::dvec3> three_in(const Value& value, double low, double high) {
    const auto numbers = numbers_in(value, 3, low, high);
    return numbers ? std::optional(glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]))
                   : std::nullopt;
}

std::string range_words(double low, double high) {
    return "from " + toml_number(low) + " to " + toml_number(high);
}

template <class Vector>
std::string array_text(const Vector& v) {
    return "[" + toml_number(v[0]) + ", " + toml_number(v[1]) + ", " + toml_number(v[2]) + "]";
}

// ---- parts of schemas

Json number_schema(double low, double high) {
    return {{"type", "number"}, {"minimum", low}, {"maximum", high}};
}

Json numbers_schema(std::size_t count, double low, double high) {
    return {{"type", "array"},
            {"items", number_schema(low, high)},
            {"minItems", count},
            {"maxItems", count}};
}

Json any_of(const std::vector<Json>& schemas) {
    return {{"anyOf", schemas}};
}

// ---- kinds

std::optional<glm::vec3> color_in(const Value& value) {
    if (const auto grey = number_in(value, 0.0, largest_intensity))
        return glm::vec3(static_cast<float>(*grey));
    if (const auto rgb = three_in(value, 0.0, largest_intensity)) return glm::vec3(*rgb);
    const auto* text = std::get_if<std::string>(&value.is);
    if (text == nullptr || !text->starts_with('#')) return std::nullopt;
    try {
        return parse_color(*text);
    } catch (const UsageError&) {
        return std::nullopt;
    }
}

std::string color_text(const glm::vec3& color) {
    const bool is_grey = color.r == color.g && color.r == color.b;
    return is_grey ? toml_number(color.r) : array_text(color);
}

Json color_schema() {
    return any_of({number_schema(0.0, largest_intensity),
                   numbers_schema(3, 0.0, largest_intensity),
                   {{"type", "string"}, {"pattern", "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"}}});
}

const std::string color_words =
    "a colour: \"#rrggbb\" or \"#rgb\" in sRGB, or linear light: one grey number or [r, g, b], "
    "each from 0 to 1e+06";

std::optional<std::string> text_in(const Value& value, std::size_t longest) {
    const auto* text = std::get_if<std::string>(&value.is);
    if (text == nullptr || text->empty() || text->size() > longest) return std::nullopt;
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
    return std::ranges::any_of(*text, is_control) ? std::nullopt : std::optional(*text);
}

Json text_schema(std::size_t longest) {
    return {{"type", "string"}, {"minLength", 1}, {"maxLength", longest}};
}

std::optional<Turn> turn_in(const Value& value) {
    const auto* table = std::get_if<Table>(&value.is);
    if (table == nullptr || table->size() != 2) return std::nullopt;
    const Entry* axis = find(*table, "axis");
    const Entry* angle = find(*table, "deg");
    if (axis == nullptr || angle == nullptr) return std::nullopt;
    const auto v = three_in(axis->value, -largest_factor, largest_factor);
    const auto deg = number_in(angle->value, -36000.0, 36000.0);
    const bool is_axis = v && glm::max(glm::abs(v->x), glm::max(glm::abs(v->y), glm::abs(v->z))) >
                                  1.0 / largest_factor;
    return is_axis && deg ? std::optional(Turn{*v, *deg}) : std::nullopt;
}

std::optional<std::vector<Turn>> turns_in(const Value& value) {
    if (const auto turn = turn_in(value)) return std::vector{*turn};
    const auto* array = std::get_if<Array>(&value.is);
    if (array == nullptr || array->empty() || array->size() > most_turns) return std::nullopt;
    std::vector<Turn> turns;
    for (const Value& item : *array) {
        const auto turn = turn_in(item);
        if (!turn) return std::nullopt;
        turns.push_back(*turn);
    }
    return turns;
}

std::string turns_text(const std::vector<Turn>& turns) {
    std::string list;
    for (const Turn& turn : turns) {
        list += (list.empty() ? "" : ", ") + ("{ axis = " + array_text(turn.axis)) +
                ", deg = " + toml_number(turn.angle_deg) + " }";
    }
    return turns.size() == 1 ? list : "[" + list + "]";
}

Json turn_schema() {
    return {{"type", "object"},
            {"properties",
             {{"axis", numbers_schema(3, -largest_factor, largest_factor)},
              {"deg", number_schema(-36000.0, 36000.0)}}},
            {"required", {"axis", "deg"}},
            {"additionalProperties", false}};
}

/// Rows of numbers, the last one 0, 0, 0, 1.
std::optional<glm::dmat4> matrix_in(const Value& value) {
    const auto* rows = std::get_if<Array>(&value.is);
    if (rows == nullptr || rows->size() != 4) return std::nullopt;
    glm::dmat4 matrix(0.0);
    for (int row = 0; row < 4; ++row) {
        const auto numbers = numbers_in((*rows)[static_cast<std::size_t>(row)], 4,
                                        -largest_coordinate, largest_coordinate);
        if (!numbers) return std::nullopt;
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = (*numbers)[static_cast<std::size_t>(column)];
    }
    const bool is_affine = glm::transpose(matrix)[3] == glm::dvec4(0.0, 0.0, 0.0, 1.0);
    return is_affine ? std::optional(matrix) : std::nullopt;
}

std::string matrix_text(const glm::dmat4& matrix) {
    std::string rows;
    for (int row = 0; row < 4; ++row) {
        std::string numbers;
        for (int column = 0; column < 4; ++column)
            numbers += (column == 0 ? "" : ", ") + toml_number(matrix[column][row]);
        rows += (row == 0 ? "[" : ", [") + numbers + "]";
    }
    return "[" + rows + "]";
}

/// The path from the folder to a file.
std::string path_text(const std::string& file, const Folder& folder) {
    const Folder to = std::filesystem::weakly_canonical(file);
    const Folder from = std::filesystem::weakly_canonical(folder.empty() ? "." : folder);
    const Folder relative = to.lexically_relative(from);
    return (relative.empty() ? to : relative).generic_string();
}

Kind<std::string> path_of(const std::string& what) {
    const auto read = [](const Value& value, const Folder& folder) {
        const auto path = text_in(value, longest_path);
        return path ? std::optional((folder / *path).generic_string()) : std::nullopt;
    };
    return {"the path of " + what + ", from the scene file's folder", text_schema(longest_path),
            read, [](const std::string& path, const Folder& folder) {
                return toml_string(path_text(path, folder));
            }};
}

}  // namespace

Kind<double> number(double low, double high) {
    return {"a number " + range_words(low, high), number_schema(low, high),
            [=](const Value& value, const Folder&) { return number_in(value, low, high); },
            [](double x, const Folder&) { return toml_number(x); }};
}

Kind<float> float_number(double low, double high) {
    const auto read = [=](const Value& value, const Folder&) {
        const auto x = number_in(value, low, high);
        return x ? std::optional(static_cast<float>(*x)) : std::nullopt;
    };
    return {"a number " + range_words(low, high), number_schema(low, high), read,
            [](float x, const Folder&) { return toml_number(x); }};
}

Kind<bool> boolean() {
    const auto read = [](const Value& value, const Folder&) {
        const bool* flag = std::get_if<bool>(&value.is);
        return flag != nullptr ? std::optional(*flag) : std::nullopt;
    };
    return {"true or false", {{"type", "boolean"}}, read, [](bool flag, const Folder&) {
                return std::string(flag ? "true" : "false");
            }};
}

Kind<std::string> text() {
    return {"text of 1 to 200 bytes", text_schema(longest_text),
            [](const Value& value, const Folder&) { return text_in(value, longest_text); },
            [](const std::string& text, const Folder&) { return toml_string(text); }};
}

Kind<std::string> one_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char* separator = i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
        list += separator + ("\"" + words[i] + "\"");
    }
    const auto read = [words](const Value& value, const Folder&) {
        const auto* text = std::get_if<std::string>(&value.is);
        const bool known = text != nullptr && std::ranges::find(words, *text) != words.end();
        return known ? std::optional(*text) : std::nullopt;
    };
    return {list, {{"enum", words}}, read, [](const std::string& text, const Folder&) {
                return toml_string(text);
            }};
}

Kind<int> samples() {
    const auto read = [](const Value& value, const Folder&) -> std::optional<int> {
        const auto* integer = std::get_if<std::int64_t>(&value.is);
        for (const int grid : {1, 2, 4}) {
            if (integer != nullptr && *integer == grid * grid) return grid;
        }
        return std::nullopt;
    };
    return {"1, 4 or 16", {{"enum", {1, 4, 16}}}, read, [](int grid, const Folder&) {
                return std::to_string(grid * grid);
            }};
}

Kind<int> whole_number(int low, int high) {
    const auto read = [=](const Value& value, const Folder&) -> std::optional<int> {
        const auto* integer = std::get_if<std::int64_t>(&value.is);
        const bool fits = integer != nullptr && *integer >= low && *integer <= high;
        return fits ? std::optional(static_cast<int>(*integer)) : std::nullopt;
    };
    return {"a whole number " + range_words(low, high),
            {{"type", "integer"}, {"minimum", low}, {"maximum", high}},
            read,
            [](int number, const Folder&) { return std::to_string(number); }};
}

Kind<int> odd_number(int most) {
    Kind<int> kind = whole_number(1, most);
    kind.words = "an odd number " + range_words(1, most);
    kind.schema["not"] = {{"multipleOf", 2}};
    kind.read = [read = kind.read](const Value& value, const Folder& folder) {
        const auto number = read(value, folder);
        return number && *number % 2 == 1 ? number : std::nullopt;
    };
    return kind;
}

Kind<raster::Viewport> picture_size() {
    const auto read = [](const Value& value, const Folder&) -> std::optional<raster::Viewport> {
        const auto numbers = numbers_in(value, 2, 1.0, raster::max_size);
        if (!numbers) return std::nullopt;
        const raster::Viewport size{static_cast<int>((*numbers)[0]),
                                    static_cast<int>((*numbers)[1])};
        const bool whole = size.width == (*numbers)[0] && size.height == (*numbers)[1];
        return whole ? std::optional(size) : std::nullopt;
    };
    Json schema = numbers_schema(2, 1, raster::max_size);
    schema["items"]["type"] = "integer";
    return {"[width, height], whole numbers " + range_words(1, raster::max_size), schema, read,
            [](const raster::Viewport& size, const Folder&) {
                return "[" + std::to_string(size.width) + ", " + std::to_string(size.height) + "]";
            }};
}

Kind<render::ViewAngles> view_angles() {
    const auto read = [](const Value& value, const Folder&) -> std::optional<render::ViewAngles> {
        const auto numbers = numbers_in(value, 2, -36000.0, 36000.0);
        if (!numbers || std::abs((*numbers)[1]) > 90.0) return std::nullopt;
        return render::ViewAngles{(*numbers)[0], (*numbers)[1]};
    };
    return {"[azimuth, elevation] in degrees, the elevation from -90 to 90",
            numbers_schema(2, -36000.0, 36000.0), read,
            [](const render::ViewAngles& view, const Folder&) {
                return "[" + toml_number(view.azimuth_deg) + ", " +
                       toml_number(view.elevation_deg) + "]";
            }};
}

Kind<glm::dvec3> point() {
    return {"[x, y, z], numbers " + range_words(-largest_coordinate, largest_coordinate),
            numbers_schema(3, -largest_coordinate, largest_coordinate),
            [](const Value& value, const Folder&) {
                return three_in(value, -largest_coordinate, largest_coordinate);
            },
            [](const glm::dvec3& v, const Folder&) { return array_text(v); }};
}

Kind<glm::dvec3> direction() {
    Kind<glm::dvec3> kind = point();
    kind.words += ", not all 0";
    kind.read = [read = kind.read](const Value& value, const Folder& folder) {
        const auto v = read(value, folder);
        return v && *v != glm::dvec3(0.0) ? v : std::nullopt;
    };
    return kind;
}

Kind<glm::dvec3> factors() {
    const auto read = [](const Value& value, const Folder&) -> std::optional<glm::dvec3> {
        if (const auto all = number_in(value, -largest_factor, largest_factor))
            return glm::dvec3(*all);
        return three_in(value, -largest_factor, largest_factor);
    };
    const auto write = [](const glm::dvec3& v, const Folder&) {
        return v.x == v.y && v.x == v.z ? toml_number(v.x) : array_text(v);
    };
    return {"a number or [x, y, z], " + range_words(-largest_factor, largest_factor),
            any_of({number_schema(-largest_factor, largest_factor),
                    numbers_schema(3, -largest_factor, largest_factor)}),
            read, write};
}

Kind<glm::vec2> repeats() {
    const auto read = [](const Value& value, const Folder&) -> std::optional<glm::vec2> {
        if (const auto both = number_in(value, -most_repeats, most_repeats))
            return glm::vec2(static_cast<float>(*both));
        const auto two = numbers_in(value, 2, -most_repeats, most_repeats);
        return two ? std::optional(glm::vec2((*two)[0], (*two)[1])) : std::nullopt;
    };
    const auto write = [](const glm::vec2& v, const Folder&) {
        return v.x == v.y ? toml_number(v.x)
                          : "[" + toml_number(v.x) + ", " + toml_number(v.y) + "]";
    };
    return {"a number or [u, v], " + range_words(-most_repeats, most_repeats),
            any_of({number_schema(-most_repeats, most_repeats),
                    numbers_schema(2, -most_repeats, most_repeats)}),
            read, write};
}

Kind<glm::vec3> color() {
    return {color_words, color_schema(),
            [](const Value& value, const Folder&) { return color_in(value); },
            [](const glm::vec3& color, const Folder&) { return color_text(color); }};
}

Kind<std::optional<glm::vec3>> color_or_none() {
    using Color = std::optional<glm::vec3>;
    const auto read = [](const Value& value, const Folder&) -> std::optional<Color> {
        const auto* text = std::get_if<std::string>(&value.is);
        if (text != nullptr && *text == "none") return Color();
        const Color color = color_in(value);
        return color ? std::optional<Color>(color) : std::nullopt;
    };
    return {"\"none\" or " + color_words, any_of({{{"const", "none"}}, color_schema()}), read,
            [](const Color& color, const Folder&) {
                return color ? color_text(*color) : toml_string("none");
            }};
}

Kind<std::string> mesh_path() {
    return path_of("a mesh file (OBJ, PLY, OFF, STL)");
}

Kind<std::string> image_path() {
    return path_of("a picture (PNG, JPEG, PPM, PGM, PFM, HDR)");
}

Kind<std::string> shape_name() {
    const auto read = [](const Value& value, const Folder&) {
        const auto name = text_in(value, longest_shape);
        return name ? std::optional("shape:" + *name) : std::nullopt;
    };
    const auto write = [](const std::string& input, const Folder&) {
        const bool has_prefix = input.starts_with("shape:");
        return toml_string(has_prefix ? input.substr(6) : input);
    };
    return {"a built-in shape, such as \"teapot\" or \"torus:48,24\"", text_schema(longest_shape),
            read, write};
}

Kind<std::vector<Turn>> turns() {
    return {"{ axis = [x, y, z], deg = ANGLE }, or up to 16 of them in an array",
            any_of({turn_schema(),
                    {{"type", "array"},
                     {"items", turn_schema()},
                     {"minItems", 1},
                     {"maxItems", most_turns}}}),
            [](const Value& value, const Folder&) { return turns_in(value); },
            [](const std::vector<Turn>& turns, const Folder&) { return turns_text(turns); }};
}

Kind<glm::dmat4> matrix() {
    return {"four rows of four numbers, the last row [0, 0, 0, 1]",
            {{"type", "array"},
             {"items", numbers_schema(4, -largest_coordinate, largest_coordinate)},
             {"minItems", 4},
             {"maxItems", 4}},
            [](const Value& value, const Folder&) { return matrix_in(value); },
            [](const glm::dmat4& matrix, const Folder&) { return matrix_text(matrix); }};
}

}  // namespace scanlight::apps
