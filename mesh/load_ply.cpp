#include "mesh/load_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "mesh/palette.h"
#include "mesh/ply_header.h"
#include "mesh/ply_values.h"
#include "mesh/srgb.h"

namespace scanlight::mesh {
namespace {

/// What a property means to us.
enum class Role { x, y, z, nx, ny, nz, red, green, blue, u, v, scalars, indices, color_list, none };

constexpr std::size_t place(Role role) {
    return static_cast<std::size_t>(role);
}
constexpr std::size_t scalar_roles = place(Role::scalars);

constexpr std::array<std::pair<std::string_view, Role>, 23> scalar_names{
    {{"x", Role::x},
     {"y", Role::y},
     {"z", Role::z},
     {"nx", Role::nx},
     {"ny", Role::ny},
     {"nz", Role::nz},
     {"red", Role::red},
     {"green", Role::green},
     {"blue", Role::blue},
     {"r", Role::red},
     {"g", Role::green},
     {"b", Role::blue},
     {"diffuse_red", Role::red},
     {"diffuse_green", Role::green},
     {"diffuse_blue", Role::blue},
     {"u", Role::u},
     {"v", Role::v},
     {"s", Role::u},
     {"t", Role::v},
     {"texture_u", Role::u},
     {"texture_v", Role::v},
     {"texture_s", Role::u},
     {"texture_t", Role::v}}};

constexpr std::array<std::pair<std::string_view, Role>, 6> list_names{
    {{"vertex_indices", Role::indices},
     {"vertex_index", Role::indices},
     {"color", Role::color_list},
     {"colors", Role::color_list},
     {"rgb", Role::color_list},
     {"rgba", Role::color_list}}};

template <std::size_t size>
Role role_named(const std::array<std::pair<std::string_view, Role>, size>& names,
                std::string_view name) {
    const auto found = std::ranges::find(names, name, &std::pair<std::string_view, Role>::first);
    return found == names.end() ? Role::none : found->second;
}

/// Only faces have corners: a list of that name elsewhere means nothing.
Role role_of(const PlyElement& element, const PlyProperty& property) {
    if (!property.is_list) return role_named(scalar_names, property.name);
    const Role role = role_named(list_names, property.name);
    return role == Role::indices && element.name != "face" ? Role::none : role;
}

/// A property in a record, shorn of its name.
struct Field {
    Role role;
    PlyType type;
    bool is_list;
    PlyType count_type;
};

std::vector<Field> fields_of(const PlyElement& element) {
    std::vector<Field> fields;
    for (const PlyProperty& property : element.properties) {
        fields.push_back(
            {role_of(element, property), property.type, property.is_list, property.count_type});
    }
    return fields;
}

bool has_all(std::span<const Field> fields, std::initializer_list<Role> roles) {
    return std::ranges::all_of(roles, [&](Role role) {
        return std::ranges::find(fields, role, &Field::role) != fields.end();
    });
}

bool has_color(std::span<const Field> fields) {
    return has_all(fields, {Role::red, Role::green, Role::blue}) ||
           has_all(fields, {Role::color_list});
}

std::uint64_t count_of(const PlyHeader& header, std::string_view element) {
    const auto found = std::ranges::find(header.elements, element, &PlyElement::name);
    return found == header.elements.end() ? 0 : found->count;
}

/// Reads record by record. Invariant: `soup_` holds the records so far; its indices are in range
/// of the vertices that the header declares.
template <class Values>
class BodyReader {
public:
    BodyReader(const PlyHeader& header, Values values, const std::string& name)
        : header_(header),
          values_(std::move(values)),
          name_(name),
          vertex_count_(count_of(header, "vertex")) {}

    PolygonSoup read() && {
        for (const PlyElement& element : header_.elements)
            read_element(element);
        give_corners_their_attributes();
        std::move(palette_).give_to(soup_);
        warn_of_the_rest();
        return std::move(soup_);
    }

private:
    void read_element(const PlyElement& element) {
        expect_room(element);
        if (element.name == "vertex") return read_vertices(element);
        if (element.name == "face") return read_faces(element);
        skip(element);
    }

    void expect_room(const PlyElement& element) {
        const std::size_t smallest = element.smallest_record(header_.encoding);
        if (smallest == 0 || element.count <= values_.room_for(smallest)) return;
        values_.fail("element " + quoted(element.name) + " declares " +
                     counted(element.count, "record", "records") + ", but only " +
                     counted(values_.bytes_left(), "byte is", "bytes are") + " left");
    }

    void skip(const PlyElement& element) {
        if (element.properties.empty()) return;
        const std::vector<Field> fields = fields_of(element);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            values_.begin_record();
            for (const Field& field : fields)
                skip(field);
            values_.end_record();
        }
        soup_.warnings.push_back(name_ + ": element " + quoted(element.name) + " (" +
                                 counted(element.count, "record", "records") + ") is passed over");
    }

    void skip(const Field& field) {
        values_.skip(field.type, field.is_list ? read_length(field) : 1);
    }

    void read_vertices(const PlyElement& element) {
        const std::vector<Field> fields = fields_of(element);
        if (!has_all(fields, {Role::x, Role::y, Role::z})) {
            values_.fail("element \"vertex\" lacks x, y or z");
        }
        const bool normals = has_all(fields, {Role::nx, Role::ny, Role::nz});
        const bool uvs = has_all(fields, {Role::u, Role::v});
        const bool colors = has_color(fields);
        soup_.positions.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            read_record(fields);
            soup_.positions.push_back(triple(Role::x));
            if (normals) soup_.normals.push_back(triple(Role::nx));
            if (colors) soup_.colors.push_back(triple(Role::red));
            if (uvs) soup_.uvs.emplace_back(scalar_[place(Role::u)], scalar_[place(Role::v)]);
        }
    }

    void read_faces(const PlyElement& element) {
        const std::vector<Field> fields = fields_of(element);
        if (!has_all(fields, {Role::indices})) {
            values_.fail("element \"face\" has no list vertex_indices or vertex_index");
        }
        const bool colors = has_color(fields);
        soup_.face_begin.reserve(element.count + 1);
        soup_.corners.reserve(std::min<std::size_t>(3 * element.count, values_.bytes_left()));
        for (std::uint64_t i = 0; i < element.count; ++i) {
            read_record(fields);
            soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
            if (colors) soup_.face_material.push_back(palette_.index_of(triple(Role::red)));
        }
    }

    void read_record(std::span<const Field> fields) {
        values_.begin_record();
        for (const Field& field : fields)
            read(field);
        values_.end_record();
    }

    void read(const Field& field) {
        if (field.role == Role::indices) return read_indices(field);
        if (field.role == Role::color_list) return read_color_list(field);
        if (field.role == Role::none) return skip(field);
        scalar_[place(field.role)] = read_scalar(field);
    }

    float read_scalar(const Field& field) {
        const bool is_color = Role::red <= field.role && field.role <= Role::blue;
        return is_color ? read_color_value(field.type) : single(values_.value(field.type));
    }

    float single(double value) const {
        if (!std::isfinite(value)) values_.fail("not a finite number");
        if (std::abs(value) > double{std::numeric_limits<float>::max()}) {
            values_.fail("a number is out of range");
        }
        return static_cast<float>(value);
    }

    float read_color_value(PlyType type) {
        const double value = values_.value(type);
        if (!is_integer(type)) return single(value);
        if (value < 0 || value > 255) values_.fail("a color is not from 0 to 255");
        return linear_from_srgb(static_cast<std::uint8_t>(value));
    }

    std::uint64_t read_length(const Field& field) {
        const double length = values_.value(field.count_type);
        if (length < 0) values_.fail("a list has a negative length");
        const auto count = static_cast<std::uint64_t>(length);
        values_.expect_room(field.type, count);
        return count;
    }

    void read_indices(const Field& field) {
        const std::uint64_t count = read_length(field);
        for (std::uint64_t i = 0; i < count; ++i) {
            soup_.corners.push_back({.position = index_from(values_.value(field.type))});
        }
    }

    std::uint32_t index_from(double value) const {
        if (!(value >= 0 && value < static_cast<double>(vertex_count_))) fail_at_index(value);
        const auto index = static_cast<std::uint32_t>(value);
        if (index != value) fail_at_index(value);
        return index;
    }

    [[noreturn]] void fail_at_index(double index) const {
        const bool is_whole = index == std::trunc(index) && std::abs(index) < 1e15;
        const std::string what = is_whole ? "vertex index " +
                                                std::to_string(static_cast<std::int64_t>(index)) +
                                                " is out of range"
                                          : "a vertex index is not an integer";
        values_.fail(what + ": the file has " + counted(vertex_count_, "vertex", "vertices"));
    }

    /// Red, green, blue, perhaps alpha; other lengths are some other thing, such as a colour for
    /// each corner.
    void read_color_list(const Field& field) {
        const std::uint64_t count = read_length(field);
        if (count != 3 && count != 4) {
            odd_color_lists_ = true;
            set_color(glm::vec3(1.0f));
            return values_.skip(field.type, count);
        }
        glm::vec3 color;
        for (const int i : {0, 1, 2})
            color[i] = read_color_value(field.type);
        values_.skip(field.type, count - 3);
        set_color(color);
    }

    void set_color(const glm::vec3& color) {
        for (const int i : {0, 1, 2})
            scalar_[place(Role::red) + static_cast<std::size_t>(i)] = color[i];
    }

    glm::vec3 triple(Role first) const {
        const std::size_t i = place(first);
        return {scalar_[i], scalar_[i + 1], scalar_[i + 2]};
    }

    /// In PLY a vertex's normal and texture coordinates have its own index.
    void give_corners_their_attributes() {
        for (PolygonSoup::Corner& corner : soup_.corners) {
            if (!soup_.normals.empty()) corner.normal = corner.position;
            if (!soup_.uvs.empty()) corner.uv = corner.position;
        }
    }

    void warn_of_the_rest() {
        const auto warn = [&](const std::string& what) {
            soup_.warnings.push_back(name_ + ": " + what);
        };
        if (odd_color_lists_) warn("color lists without 3 or 4 values are passed over");
        if (const std::size_t bytes = values_.unread(); bytes > 0) {
            warn(counted(bytes, "byte", "bytes") + " after the last record passed over");
        }
        if (soup_.face_count() == 0) warn("has no faces");
    }

    const PlyHeader& header_;
    Values values_;
    std::string name_;
    std::uint64_t vertex_count_;
    PolygonSoup soup_;
    Palette palette_;
    std::array<float, scalar_roles> scalar_{};  // of this record
    bool odd_color_lists_ = false;
};

template <class Values>
PolygonSoup read_body(const PlyHeader& header, std::string_view bytes, const std::string& name) {
    return BodyReader<Values>(header, Values(bytes, name, header.size), name).read();
}

}  // namespace

PolygonSoup load_ply(std::string_view bytes, const std::string& name) {
    const PlyHeader header = read_ply_header(bytes, name);
    switch (header.encoding) {
        case PlyEncoding::ascii:
            return read_body<PlyTextValues>(header, bytes, name);
        case PlyEncoding::little_endian:
            return read_body<PlyBinaryValues<std::endian::little>>(header, bytes, name);
        case PlyEncoding::big_endian:
            break;
    }
    return read_body<PlyBinaryValues<std::endian::big>>(header, bytes, name);
}

}  // namespace scanlight::mesh
