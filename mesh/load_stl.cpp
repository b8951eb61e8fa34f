#include "mesh/load_stl.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "mesh/cursor.h"
#include "mesh/file_error.h"
#include "mesh/load_number.h"
#include "mesh/weld.h"

namespace scanlight::mesh {
namespace {

constexpr std::size_t count_offset = 80;
constexpr std::size_t header_size = 84;
constexpr std::size_t normal_size = 12;
constexpr std::size_t point_size = 12;
constexpr std::size_t triangle_size = 50;

std::uint64_t declared_triangles(std::string_view bytes) {
    return load_number<std::uint32_t, std::endian::little>(bytes.data() + count_offset);
}

[[noreturn]] void fail_at_byte(std::size_t offset, const std::string& name,
                               const std::string& reason) {
    throw FileError(name + ": byte " + std::to_string(offset) + ": " + reason);
}

/// One binary file.
class BinaryStl {
public:
    BinaryStl(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    PolygonSoup read() const {
        expect_right_size();
        PolygonSoup soup;
        const std::uint64_t triangles = declared_triangles(bytes_);
        Welder welder(triangles);
        soup.corners.reserve(3 * triangles);
        soup.face_begin.reserve(triangles + 1);
        for (std::uint64_t i = 0; i < triangles; ++i) {
            const std::size_t first = header_size + i * triangle_size + normal_size;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                soup.corners.push_back({welder.index_of(point_at(first + corner * point_size))});
            }
            soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
        }
        soup.positions = std::move(welder).take();
        warn_of_tail(soup, header_size + triangles * triangle_size);
        return soup;
    }

private:
    void warn_of_tail(PolygonSoup& soup, std::size_t end) const {
        if (end == bytes_.size()) return;
        soup.warnings.push_back(name_ + ": " + counted(bytes_.size() - end, "byte", "bytes") +
                                " after the last triangle passed over");
    }

    void expect_right_size() const {
        if (bytes_.size() < header_size) {
            fail_at_byte(bytes_.size(), name_, "ends inside the header of a binary STL file");
        }
        if (is_binary_stl(bytes_)) return;
        fail_at_byte(count_offset, name_,
                     counted(declared_triangles(bytes_), "triangle is", "triangles are") +
                         " declared, but the file's length is that of " +
                         std::to_string((bytes_.size() - header_size) / triangle_size));
    }

    glm::vec3 point_at(std::size_t offset) const {
        return {number_at(offset), number_at(offset + 4), number_at(offset + 8)};
    }

    float number_at(std::size_t offset) const {
        const auto number = load_number<float, std::endian::little>(bytes_.data() + offset);
        if (!std::isfinite(number)) fail_at_byte(offset, name_, "not a finite number");
        return number;
    }

    std::string_view bytes_;
    std::string name_;
};

/// Reads solid by solid. Invariant: `soup_` holds the facets so far.
class StlTextReader {
public:
    StlTextReader(std::string_view bytes, const std::string& name) : text_(bytes, name) {
        expect_text(text_, bytes);
    }

    PolygonSoup read() && {
        do {
            read_solid();
            text_.skip_space();
        } while (!text_.at_end());
        soup_.positions = std::move(welder_).take();
        return std::move(soup_);
    }

private:
    void read_solid() {
        expect("solid");
        text_.next_line();  // the rest is its name
        while (!next_is("endsolid"))
            read_facet();
        text_.next_line();
    }

    void read_facet() {
        expect("facet");
        expect("normal");
        // Exporters write NaN for the normal of a sliver; it is worked out anew anyway.
        for (int i = 0; i < 3; ++i)
            next_word("the facet's normal");
        expect("outer");
        expect("loop");
        while (!next_is("endloop"))
            read_vertex();
        expect("endfacet");
        soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    }

    void read_vertex() {
        expect("vertex");
        const float x = text_.single();
        const float y = text_.single();
        soup_.corners.push_back({welder_.index_of({x, y, text_.single()})});
    }

    std::string_view next_word(std::string_view wanted) {
        text_.skip_space();
        const std::string_view word = text_.word();
        if (word.empty()) text_.fail("ends before " + std::string(wanted));
        return word;
    }

    void expect(std::string_view keyword) {
        const std::string_view word = next_word(keyword);
        if (!equal_ignoring_case(word, keyword)) {
            text_.fail(quoted(word) + " stands where " + quoted(keyword) + " must");
        }
    }

    /// Steps over the keyword if it comes next.
    bool next_is(std::string_view keyword) {
        text_.skip_space();
        const std::size_t before = text_.offset();
        if (equal_ignoring_case(text_.word(), keyword)) return true;
        text_.seek(before);
        return false;
    }

    Cursor text_;
    Welder welder_;
    PolygonSoup soup_;
};

/// Binary files may start with "solid" too, but then hold zero bytes.
bool is_text_stl(std::string_view bytes) {
    Cursor text(bytes, "");
    text.skip_space();
    return equal_ignoring_case(text.word(), "solid") &&
           bytes.substr(0, 1024).find('\0') == bytes.npos;
}

PolygonSoup load_any_stl(std::string_view bytes, const std::string& name) {
    if (!is_binary_stl(bytes) && is_text_stl(bytes)) return StlTextReader(bytes, name).read();
    return BinaryStl(bytes, name).read();
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
    if (bytes.size() < header_size) return false;
    const std::size_t body = bytes.size() - header_size;
    return body / triangle_size == declared_triangles(bytes);
}

PolygonSoup load_stl(std::string_view bytes, const std::string& name) {
    PolygonSoup soup = load_any_stl(bytes, name);
    if (soup.face_count() == 0) soup.warnings.push_back(name + ": has no faces");
    return soup;
}

}  // namespace scanlight::mesh
