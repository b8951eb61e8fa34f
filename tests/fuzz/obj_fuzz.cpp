#include <algorithm>
#include <memory>
#include <optional>

#include "mesh/load_obj.h"
#include "tests/fuzz/fuzz_reader.h"

using namespace scanlight::mesh;

namespace {

/// A name that isn't refused finds a small library, or nothing if it starts with 'n'.
std::optional<Bytes> open_library(std::string_view name) {
    constexpr std::string_view library = "newmtl a\nKd 1 0 0\nnewmtl b\nd 0.5\n";
    if (!reason_to_refuse(name).empty()) throw FileError("refused");
    if (name.starts_with('n')) return std::nullopt;
    auto data = std::make_unique<char[]>(library.size());
    std::ranges::copy(library, data.get());
    return Bytes(std::move(data), library.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    return fuzz_reader(bytes, size,
                       [](std::string_view text) { return load_obj(text, "fuzz", open_library); });
}
