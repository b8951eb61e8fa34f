#include "mesh/load_ply.h"
#include "tests/fuzz/fuzz_reader.h"

using namespace scanlight::mesh;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return fuzz_reader(bytes, size, [](std::string_view text) { return load_ply(text, "fuzz"); });
}
