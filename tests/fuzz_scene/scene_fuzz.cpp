#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "apps/scene/placement.h"
#include "apps/scene/read_scene.h"
#include "apps/scene/write_scene.h"
#include "mesh/file_error.h"

using namespace scanlight;

namespace {

void expect(bool right, std::string_view promise) {
    if (right) return;
    std::cerr << "broken: " << promise << "\n";
    std::abort();
}

apps::SceneOptions read(std::string_view text) {
    apps::SceneOptions options;
    apps::read_scene(options, text, "fuzz", "/nowhere");
    return options;
}

}  // namespace

/// Any bytes are a scene that is written and read again without a change, or a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        const apps::SceneOptions options = read({reinterpret_cast<const char*>(bytes), size});
        for (const apps::ObjectOptions& object : options.objects)
            apps::matrix_of(object.placement);
        const std::string written = apps::scene_text(options, "/nowhere");
        expect(apps::scene_text(read(written), "/nowhere") == written, "what is written is read");
    } catch (const mesh::FileError& error) {
        expect(std::string_view(error.what()).starts_with("fuzz"), "a message names its file");
    }
    return 0;
}
