#include "mesh/load_mtl.h"
#include "mesh/mtl_text.h"
#include "tests/fuzz/fuzz_reader.h"

using namespace scanlight::mesh;

/// A back slash at the end of a file joins it to a line that is written after it.
void expect_read_back(std::string_view text, const std::vector<Material>& materials) {
    if (text.find('\\') != text.npos) return;
    expect(load_mtl(mtl_text(materials), "fuzz").materials == materials, "read back the same");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return fuzz_reader(bytes, size, [](std::string_view text) {
        PolygonSoup soup;
        MaterialLibrary library = load_mtl(text, "fuzz");
        expect_read_back(text, library.materials);
        soup.materials = std::move(library.materials);
        soup.warnings = std::move(library.warnings);
        return soup;
    });
}
