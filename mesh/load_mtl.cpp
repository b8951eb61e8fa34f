#include "mesh/load_mtl.h"

#include <optional>

#include "mesh/cursor.h"
#include "mesh/mtl_words.h"
#include "mesh/read_texture_map.h"
#include "mesh/warnings.h"

namespace scanlight::mesh {
namespace {

/// Reads statement by statement. Invariant: `library_` holds what the statements so far say.
class MtlReader {
public:
    MtlReader(std::string_view bytes, const std::string& name)
        : text_(bytes, name, {.hash_comments = true, .continued_lines = true}) {
        expect_text(text_, bytes);
    }

    MaterialLibrary read() && {
        for (; !text_.at_end(); text_.next_line())
            read_statement(text_.word());
        library_.warnings = warnings_.lines(text_);
        return std::move(library_);
    }

private:
    void read_statement(std::string_view word) {
        if (word == "newmtl") return start_material();
        if (word == "Ka") return read_color(word, &Material::ambient);
        if (word == "Kd") return read_color(word, &Material::diffuse);
        if (word == "Ks") return read_color(word, &Material::specular);
        if (word == "Ke") return read_color(word, &Material::emission);
        if (word == "Tf") return read_color(word, &Material::filter);
        if (word == "Ns") return read_number(word, &Material::exponent);
        if (word == "Ni") return read_number(word, &Material::refraction);
        if (word == "d") return read_dissolve(word);
        if (word == "Tr") return read_transparency(word);
        if (word == "illum") return read_illumination(word);
        if (word == "refl") return read_map(word, {});
        read_map_or_pass_over(word);
    }

    /// Exporters write map_bump and map_Bump.
    void read_map_or_pass_over(std::string_view word) {
        for (const auto& [statement, use] : map_statements) {
            if (equal_ignoring_case(word, statement)) return read_map(word, use);
        }
        if (word.empty()) return;
        if (word == "disp") return warn(word, "a displacement");
        if (word == "decal") return warn(word, "a decal");
        warnings_.add(text_.offset(), "statement " + quoted(word) + " is passed over");
    }

    /// A reflection map tells its use itself.
    void read_map(std::string_view word, std::optional<MapUse> use) {
        Material& target = material(word);
        auto arguments = read_texture_map(word, text_, warnings_);
        if (!arguments) return;
        target.maps[use.value_or(arguments->reflection)] = std::move(arguments->map);
    }

    void start_material() {
        const std::string_view name = text_.rest_of_line();
        if (name.empty()) text_.fail("newmtl has no name");
        library_.materials.push_back({.name = std::string(name)});
        dissolve_.reset();
    }

    Material& material(std::string_view word) {
        if (library_.materials.empty()) text_.fail(std::string(word) + " before the first newmtl");
        return library_.materials.back();
    }

    /// One number is a grey.
    void read_color(std::string_view word, glm::vec3 Material::*color) {
        Material& target = material(word);
        if (text_.accept("spectral")) return warn(word, "a spectral curve");
        if (text_.accept("xyz")) return warn(word, "a CIE XYZ color");
        const float red = text_.single();
        if (text_.at_line_end()) {
            target.*color = glm::vec3(red);
            return;
        }
        const float green = text_.single();
        target.*color = {red, green, text_.single()};
        expect_line_end(word);
    }

    void read_number(std::string_view word, float Material::*number) {
        Material& target = material(word);
        target.*number = text_.single();
        expect_line_end(word);
    }

    void read_dissolve(std::string_view word) {
        if (text_.accept("-halo")) warn(word, "a halo");
        read_number(word, &Material::opacity);
        dissolve_ = material(word).opacity;
    }

    /// Exporters disagree on which way Tr runs, not so on d.
    void read_transparency(std::string_view word) {
        Material& target = material(word);
        const float opacity = 1 - text_.single();
        expect_line_end(word);
        if (!dissolve_) {
            target.opacity = opacity;
        } else if (*dissolve_ != opacity) {
            warn(word, "a value at odds with d");
        }
    }

    void read_illumination(std::string_view word) {
        Material& target = material(word);
        const std::int64_t model = text_.integer();
        expect_line_end(word);
        if (model < 0 || model > 10) return warn(word, "a model other than 0 to 10");
        target.illumination = static_cast<int>(model);
    }

    void expect_line_end(std::string_view word) {
        if (!text_.at_line_end()) text_.fail(std::string(word) + " has too many numbers");
    }

    void warn(std::string_view word, const char* what) {
        warnings_.add(text_.offset(),
                      std::string(word) + " gives " + what + ", which is passed over");
    }

    Cursor text_;
    MaterialLibrary library_;
    Warnings warnings_;
    std::optional<float> dissolve_;  // what d said of this material
};

}  // namespace

MaterialLibrary load_mtl(std::string_view bytes, const std::string& name) {
    return MtlReader(bytes, name).read();
}

}  // namespace scanlight::mesh
