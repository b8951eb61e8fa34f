#include "mesh/load_obj.h"

#include <algorithm>
#include <array>
#include <string>

#include "mesh/cursor.h"
#include "mesh/obj_materials.h"

namespace scanlight::mesh {
namespace {

constexpr LineRules obj_rules{.hash_comments = true, .continued_lines = true};

/// Statements that shape no polygon and go without saying.
constexpr std::array<std::string_view, 31> silent_statements{
    "g",     "o",     "s",     "mg",     "vp",         "cstype",    "deg",  "bmat",
    "step",  "curv",  "curv2", "surf",   "parm",       "trim",      "hole", "scrv",
    "sp",    "end",   "con",   "bevel",  "c_interp",   "d_interp",  "lod",  "usemap",
    "ctech", "stech", "call",  "maplib", "shadow_obj", "trace_obj", "csh"};

/// Statements passed over that a person should hear of: how many, and where the first stood.
struct Skipped {
    std::size_t count = 0;
    std::size_t first_offset = 0;
    std::string first_word;

    void add(std::size_t offset, std::string_view word) {
        if (count++ > 0) return;
        first_offset = offset;
        first_word = quoted(word);
    }
};

/// Reads statement by statement. Invariant: `soup_` holds what the statements so far say, save
/// that positive indices may still point past the end: a face may come before its vertices.
class ObjReader {
public:
    ObjReader(std::string_view bytes, const std::string& name, const OpenFile& open)
        : bytes_(bytes), text_(bytes, name, obj_rules), materials_(name, open) {
        expect_text(text_, bytes);
    }

    PolygonSoup read() && {
        for (; !text_.at_end(); text_.next_line())
            read_statement(text_.word());
        expect_indices_in_range();
        std::move(materials_).give_to(soup_);
        warn_of(lines_and_points_, "line or point element");
        warn_of(unknown_, "unknown statement");
        if (soup_.face_count() == 0) soup_.warnings.push_back(text_.name() + ": has no faces");
        return std::move(soup_);
    }

private:
    void read_statement(std::string_view word) {
        if (word == "v") return read_vertex();
        if (word == "f") return read_face();
        if (word == "vn") return read_normal();
        if (word == "vt") return read_uv();
        if (word == "usemtl") return materials_.use(read_name(word));
        if (word == "mtllib") return materials_.read_libraries(read_name(word), text_);
        pass_over(word);
    }

    void pass_over(std::string_view word) {
        if (word.empty() || std::ranges::find(silent_statements, word) != silent_statements.end()) {
            return;
        }
        const bool drawable = word == "l" || word == "p";
        (drawable ? lines_and_points_ : unknown_).add(text_.offset(), word);
    }

    /// x y z, perhaps a weight, perhaps r g b.
    void read_vertex() {
        std::array<float, 7> number{text_.single(), text_.single(), text_.single()};
        std::size_t count = 3;
        while (!text_.at_line_end() && count < number.size())
            number[count++] = text_.single();
        expect_line_end("a vertex has more than 7 numbers");
        if (count == 5) text_.fail("a vertex has 5 numbers: only 3, 4, 6 or 7 mean something");
        soup_.positions.emplace_back(number[0], number[1], number[2]);
        if (count >= 6) {
            add_color({number[3], number[4], number[5]});
        } else if (!soup_.colors.empty()) {
            soup_.colors.emplace_back(1.0f);
        }
    }

    void add_color(const glm::vec3& color) {
        if (soup_.colors.empty()) soup_.colors.resize(soup_.positions.size() - 1, glm::vec3(1.0f));
        soup_.colors.push_back(color);
    }

    void read_normal() {
        const float x = text_.single();
        const float y = text_.single();
        soup_.normals.emplace_back(x, y, text_.single());
        expect_line_end("a normal has more than 3 numbers");
    }

    /// u, perhaps v, perhaps a depth that no surface needs.
    void read_uv() {
        const float u = text_.single();
        const float v = text_.at_line_end() ? 0.0f : text_.single();
        soup_.uvs.emplace_back(u, v);
        if (!text_.at_line_end()) text_.single();
        expect_line_end("a texture coordinate has more than 3 numbers");
    }

    void expect_line_end(const char* complaint) {
        if (!text_.at_line_end()) text_.fail(complaint);
    }

    void read_face() {
        while (!text_.at_line_end())
            soup_.corners.push_back(read_corner());
        soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
        materials_.add_face();
    }

    /// v, v/vt, v//vn or v/vt/vn.
    PolygonSoup::Corner read_corner() {
        const std::size_t start = text_.offset();
        if (!text_.integer_follows()) fail_at_corner(start);
        PolygonSoup::Corner corner{.position = read_index("vertex", soup_.positions.size())};
        if (text_.accept_here('/')) {
            if (text_.integer_follows()) {
                corner.uv = read_index("texture coordinate", soup_.uvs.size());
            }
            if (text_.accept_here('/') && text_.integer_follows()) {
                corner.normal = read_index("normal", soup_.normals.size());
            }
        }
        if (!text_.at_word_end()) fail_at_corner(start);
        return corner;
    }

    [[noreturn]] void fail_at_corner(std::size_t start) {
        text_.seek(start);
        text_.fail_at_word("is not a corner: v, v/vt, v//vn or v/vt/vn");
    }

    /// 1 is the file's first, -1 the latest so far.
    std::uint32_t read_index(const char* what, std::size_t so_far) {
        const std::int64_t index = text_.integer_here();
        const auto count = static_cast<std::int64_t>(so_far);
        if (index > 0 && index <= std::int64_t{max_file_bytes}) {
            return static_cast<std::uint32_t>(index - 1);
        }
        if (index < 0 && index >= -count) return static_cast<std::uint32_t>(count + index);
        if (index == 0) text_.fail(std::string(what) + " index 0: they count from 1");
        fail_out_of_range(text_.offset(), what, index, so_far, " so far");
    }

    [[noreturn]] void fail_out_of_range(std::size_t offset, const std::string& what,
                                        std::int64_t index, std::size_t count,
                                        const char* when) const {
        const std::string many = what == "vertex" ? "vertices" : what + "s";
        text_.fail_at(offset, what + " index " + std::to_string(index) +
                                  " is out of range: the file has " + counted(count, what, many) +
                                  when);
    }

    void expect_indices_in_range() const {
        for (std::size_t f = 0; f < soup_.face_count(); ++f) {
            for (const PolygonSoup::Corner& corner : soup_.face(f)) {
                expect_in_range(f, "vertex", corner.position, soup_.positions.size());
                expect_in_range(f, "texture coordinate", corner.uv, soup_.uvs.size());
                expect_in_range(f, "normal", corner.normal, soup_.normals.size());
            }
        }
    }

    void expect_in_range(std::size_t face, const char* what, std::uint32_t index,
                         std::size_t count) const {
        if (index < count || index == PolygonSoup::none) return;
        fail_out_of_range(offset_of_face(face), what, std::int64_t{index} + 1, count, "");
    }

    /// Reads the file again, for a message only: so no face has to remember its line.
    std::size_t offset_of_face(std::size_t face) const {
        Cursor text(bytes_, text_.name(), obj_rules);
        for (std::size_t seen = 0; !text.at_end(); text.next_line()) {
            if (text.word() == "f" && seen++ == face) break;
            while (!text.at_line_end())
                text.word();
        }
        return text.offset();
    }

    std::string_view read_name(std::string_view statement) {
        const std::string_view name = text_.rest_of_line();
        if (name.empty()) text_.fail(std::string(statement) + " has no name");
        return name;
    }

    void warn_of(const Skipped& skipped, const std::string& what) {
        if (skipped.count == 0) return;
        soup_.warnings.push_back(text_.where(skipped.first_offset) + ": " + what + " " +
                                 skipped.first_word + " is passed over, the first of " +
                                 std::to_string(skipped.count));
    }

    std::string_view bytes_;
    Cursor text_;
    PolygonSoup soup_;
    ObjMaterials materials_;
    Skipped lines_and_points_;
    Skipped unknown_;
};

}  // namespace

PolygonSoup load_obj(std::string_view bytes, const std::string& name, const OpenFile& open) {
    return ObjReader(bytes, name, open).read();
}

}  // namespace scanlight::mesh
