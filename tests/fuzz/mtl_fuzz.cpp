#include "mesh/load_mtl.h"
#include "tests/fuzz/fuzz_reader.h"

using namespace scanlight::mesh;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return fuzz_reader(bytes, size, [](std::string_view text) {
        PolygonSoup soup;
        MaterialLibrary library = load_mtl(text, "fuzz");
        soup.materials = std::move(library.materials);
        soup.warnings = std::move(library.warnings);
        return soup;
    });
}
