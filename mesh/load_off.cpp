#include "mesh/load_off.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "mesh/cursor.h"
#include "mesh/palette.h"
#include "mesh/srgb.h"

namespace scanlight::mesh {
namespace {

/// What a keyword such as "STCNOFF" promises of each vertex, beyond its position.
struct Attributes {
    bool normals = false;
    bool colors = false;
    bool uvs = false;

    /// Numbers of a vertex, without its colour.
    std::size_t fixed_numbers() const { return 3u + (normals ? 3 : 0) + (uvs ? 2 : 0); }
};

/// A number, and whether it was written as an integer.
struct Number {
    float value = 0;
    bool is_integer = false;
};

/// Reads line by line. Invariant: `soup_` holds the lines so far, its indices in range of the
/// vertices that the file declares.
class OffReader {
public:
    OffReader(std::string_view bytes, const std::string& name)
        : text_(bytes, name, {.hash_comments = true}) {
        expect_text(text_, bytes);
    }

    PolygonSoup read() && {
        attributes_ = read_keyword();
        vertex_count_ = read_count("vertices");
        const std::uint64_t face_count = read_count("faces");
        if (!text_.at_line_end()) text_.integer();  // edges, which nobody counts right
        expect_room(vertex_count_, 2 * least_numbers(), "vertices");
        expect_room(face_count, 2, "faces");
        soup_.positions.reserve(vertex_count_);
        for (std::uint64_t i = 0; i < vertex_count_; ++i)
            read_vertex();
        for (std::uint64_t i = 0; i < face_count; ++i)
            read_face();
        std::move(palette_).give_to(soup_);
        warn_of_the_rest();
        return std::move(soup_);
    }

private:
    Attributes read_keyword() {
        text_.skip_space();
        const std::size_t start = text_.offset();
        const std::string_view word = text_.word();
        const std::size_t keyword = word.find("OFF");
        if (keyword == word.npos) {
            text_.seek(start);  // the keyword may be missing
            return {};
        }
        text_.seek(start + keyword + 3);  // the first count may follow without a blank
        if (text_.accept("BINARY")) text_.fail("binary OFF is not read here: convert it to text");
        return attributes_of(word.substr(0, keyword));
    }

    Attributes attributes_of(std::string_view prefix) const {
        Attributes attributes;
        for (; !prefix.empty(); prefix.remove_prefix(1)) {
            if (prefix.starts_with("ST")) {
                attributes.uvs = true;
                prefix.remove_prefix(1);
            } else if (prefix.front() == 'C') {
                attributes.colors = true;
            } else if (prefix.front() == 'N') {
                attributes.normals = true;
            } else {
                text_.fail("OFF with prefix " + quoted(prefix) + " is not read here");
            }
        }
        return attributes;
    }

    std::uint64_t read_count(const std::string& what) {
        text_.skip_space();
        if (text_.at_end()) text_.fail("the count of " + what + " is missing");
        const std::int64_t count = text_.integer();
        if (count < 0) text_.fail("a negative count of " + what);
        return static_cast<std::uint64_t>(count);
    }

    std::size_t least_numbers() const {
        return attributes_.fixed_numbers() + (attributes_.colors ? 3 : 0);
    }

    /// A number and what parts it from the next take 2 bytes, but for the file's last.
    void expect_room(std::uint64_t count, std::size_t bytes_each, const std::string& what) const {
        if (count <= (text_.bytes_left() + 1) / bytes_each) return;
        text_.fail(std::to_string(count) + " " + what + " are declared, but only " +
                   counted(text_.bytes_left(), "byte is", "bytes are") + " left");
    }

    Number read_number() {
        const std::size_t before = text_.offset();
        const float value = text_.single();
        return {value, text_.since(before).find_first_of(".eE") == std::string_view::npos};
    }

    /// The line's numbers: x y z, nx ny nz, r g b and perhaps a, s t.
    void read_vertex() {
        std::array<Number, 12> number;
        std::size_t count = 0;
        text_.skip_space();
        while (count == 0 || !text_.at_line_end()) {
            if (count == number.size()) fail_at_count("more than 12");
            number[count++] = read_number();
        }
        const std::size_t color_numbers = count - std::min(count, attributes_.fixed_numbers());
        const bool right = attributes_.colors ? color_numbers == 3 || color_numbers == 4
                                              : count == attributes_.fixed_numbers();
        if (!right) fail_at_count(std::to_string(count));
        add_vertex(number, color_numbers);
    }

    [[noreturn]] void fail_at_count(const std::string& count) const {
        const std::size_t least = least_numbers();
        text_.fail("a vertex has " + count + " numbers, not " + std::to_string(least) +
                   (attributes_.colors ? " or " + std::to_string(least + 1) : ""));
    }

    void add_vertex(std::span<const Number> number, std::size_t color_numbers) {
        const auto triple = [&](std::size_t i) {
            return glm::vec3(number[i].value, number[i + 1].value, number[i + 2].value);
        };
        soup_.positions.push_back(triple(0));
        if (attributes_.normals) soup_.normals.push_back(triple(3));
        const std::size_t color = attributes_.normals ? 6 : 3;
        if (attributes_.colors) soup_.colors.push_back(linear(number.subspan(color, 3)));
        const std::size_t uv = color + color_numbers;
        if (attributes_.uvs) soup_.uvs.emplace_back(number[uv].value, number[uv + 1].value);
    }

    glm::vec3 linear(std::span<const Number> color) const {
        const bool is_srgb = std::ranges::all_of(color, &Number::is_integer);
        if (!is_srgb) return {color[0].value, color[1].value, color[2].value};
        return {linear(color[0].value), linear(color[1].value), linear(color[2].value)};
    }

    float linear(float value_srgb) const {
        if (value_srgb < 0 || value_srgb > 255) text_.fail("a color is not from 0 to 255");
        return linear_from_srgb(static_cast<std::uint8_t>(value_srgb));
    }

    void read_face() {
        text_.skip_space();
        const std::int64_t size = text_.integer();
        if (size < 0) text_.fail("a face has a negative number of corners");
        expect_room(static_cast<std::uint64_t>(size), 2, "corners");
        for (std::int64_t i = 0; i < size; ++i)
            soup_.corners.push_back(read_corner());
        soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
        soup_.face_material.push_back(read_face_material());
    }

    PolygonSoup::Corner read_corner() {
        const std::int64_t index = text_.integer();
        if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_) {
            text_.fail("vertex index " + std::to_string(index) + " is out of range: the file has " +
                       counted(vertex_count_, "vertex", "vertices"));
        }
        const auto i = static_cast<std::uint32_t>(index);
        return {i, attributes_.normals ? i : PolygonSoup::none,
                attributes_.uvs ? i : PolygonSoup::none};
    }

    /// Nothing, a colour, or an index into a colour map that the file does not hold.
    std::uint32_t read_face_material() {
        std::array<Number, 4> color;
        std::size_t count = 0;
        while (!text_.at_line_end() && count < color.size())
            color[count++] = read_number();
        if (count == 2 || !text_.at_line_end()) text_.fail("a face's color has 1, 3 or 4 numbers");
        if (count == 1) ++map_indices_;
        return count < 3 ? 0 : palette_.index_of(linear(std::span(color).first(3)));
    }

    void warn_of_the_rest() {
        const auto warn = [&](const std::string& what) {
            soup_.warnings.push_back(text_.name() + ": " + what);
        };
        if (map_indices_ > 0)
            warn(counted(map_indices_, "face has", "faces have") +
                 " an index into a color map, which is passed over");
        text_.skip_space();
        if (!text_.at_end()) warn("the text after the last face is passed over");
        if (soup_.face_count() == 0) warn("has no faces");
    }

    Cursor text_;
    Attributes attributes_;
    std::uint64_t vertex_count_ = 0;
    PolygonSoup soup_;
    Palette palette_;
    std::size_t map_indices_ = 0;
};

}  // namespace

PolygonSoup load_off(std::string_view bytes, const std::string& name) {
    return OffReader(bytes, name).read();
}

}  // namespace scanlight::mesh
