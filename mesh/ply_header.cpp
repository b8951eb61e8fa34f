#include "mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "mesh/cursor.h"

namespace scanlight::mesh {
namespace {

constexpr std::size_t max_elements = 64;
constexpr std::size_t max_properties = 256;  // of one element

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{
    {{"char", PlyType::int8},
     {"int8", PlyType::int8},
     {"uchar", PlyType::uint8},
     {"uint8", PlyType::uint8},
     {"short", PlyType::int16},
     {"int16", PlyType::int16},
     {"ushort", PlyType::uint16},
     {"uint16", PlyType::uint16},
     {"int", PlyType::int32},
     {"int32", PlyType::int32},
     {"uint", PlyType::uint32},
     {"uint32", PlyType::uint32},
     {"float", PlyType::float32},
     {"float32", PlyType::float32},
     {"double", PlyType::float64},
     {"float64", PlyType::float64}}};

/// Reads line by line. Invariant: `elements_` holds what the lines so far declare.
class HeaderReader {
public:
    HeaderReader(std::string_view bytes, const std::string& name)
        : text_(bytes, name), bytes_(bytes) {}

    PlyHeader read() && {
        if (text_.word() != "ply") text_.fail("a PLY file starts with \"ply\"");
        leave_line();
        while (read_line(text_.word()))
            leave_line();
        leave_last_line();
        if (!encoding_) text_.fail("the header has no format line");
        return {*encoding_, std::move(elements_), text_.offset()};
    }

private:
    /// False at the end of the header.
    bool read_line(std::string_view word) {
        if (word == "end_header") return false;
        if (word == "format")
            read_format();
        else if (word == "element")
            read_element();
        else if (word == "property")
            read_property();
        else if (!word.empty() && word != "comment" && word != "obj_info") {
            text_.fail(quoted(word) + " is not a header statement");
        }
        return true;
    }

    void leave_line() {
        text_.next_line();
        if (text_.at_end()) text_.fail("the header has no end_header");
    }

    /// Binary data may start with the byte of a line feed: after a header whose lines end in CR
    /// alone, one byte ends this one too.
    void leave_last_line() {
        const std::size_t first_end = bytes_.find_first_of("\r\n");
        const bool lone_cr = bytes_[first_end] == '\r' && bytes_[first_end + 1] != '\n';
        if (!text_.at_line_end()) text_.fail("end_header has more words on its line");
        if (!lone_cr)
            text_.next_line();
        else if (!text_.accept_here('\r'))
            text_.fail("end_header ends unlike the other lines");
    }

    void read_format() {
        const std::string_view encoding = text_.word();
        if (encoding == "ascii")
            encoding_ = PlyEncoding::ascii;
        else if (encoding == "binary_little_endian")
            encoding_ = PlyEncoding::little_endian;
        else if (encoding == "binary_big_endian")
            encoding_ = PlyEncoding::big_endian;
        else
            text_.fail(quoted(encoding) + " is not a PLY format");
        if (text_.word() != "1.0") text_.fail("only version 1.0 of PLY is known");
    }

    void read_element() {
        const std::string name(text_.word());
        if (name.empty()) text_.fail("the element has no name");
        const auto same_name = [&](const PlyElement& other) { return other.name == name; };
        if (std::ranges::any_of(elements_, same_name)) {
            text_.fail("element " + quoted(name) + " is declared twice");
        }
        if (elements_.size() == max_elements) text_.fail("too many elements");
        const std::int64_t count = text_.integer();
        if (count < 0) text_.fail("element " + quoted(name) + " has a negative count");
        elements_.push_back({name, static_cast<std::uint64_t>(count), {}});
    }

    void read_property() {
        if (elements_.empty()) text_.fail("a property before the first element");
        PlyProperty property{.name = {}, .type = PlyType::float32};
        std::string_view type = text_.word();
        if (type == "list") {
            property.is_list = true;
            property.count_type = type_named(text_.word());
            type = text_.word();
        }
        property.type = type_named(type);
        property.name = text_.word();
        if (property.name.empty()) text_.fail("the property has no name");
        add(std::move(property), elements_.back());
    }

    void add(PlyProperty property, PlyElement& element) {
        const auto same_name = [&](const PlyProperty& other) {
            return other.name == property.name;
        };
        if (std::ranges::any_of(element.properties, same_name)) {
            text_.fail("property " + quoted(property.name) + " is declared twice");
        }
        if (property.is_list && !is_integer(property.count_type)) {
            text_.fail("the length of list " + quoted(property.name) + " is not an integer type");
        }
        if (element.properties.size() == max_properties) text_.fail("too many properties");
        element.properties.push_back(std::move(property));
    }

    PlyType type_named(std::string_view name) const {
        const auto type =
            std::ranges::find(type_names, name, &decltype(type_names)::value_type::first);
        if (type == type_names.end()) text_.fail(quoted(name) + " is not a PLY type");
        return type->second;
    }

    Cursor text_;
    std::string_view bytes_;
    std::optional<PlyEncoding> encoding_;
    std::vector<PlyElement> elements_;
};

}  // namespace

bool is_integer(PlyType type) {
    return type != PlyType::float32 && type != PlyType::float64;
}

bool PlyElement::is_fixed_size() const {
    return std::ranges::none_of(properties, &PlyProperty::is_list);
}

std::size_t PlyElement::smallest_record(PlyEncoding encoding) const {
    std::size_t size = 0;
    for (const PlyProperty& property : properties) {
        const PlyType type = property.is_list ? property.count_type : property.type;
        size += encoding == PlyEncoding::ascii ? 2 : size_of(type);
    }
    return size;
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace scanlight::mesh
