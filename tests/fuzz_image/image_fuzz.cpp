#include <cstddef>
#include <cstdint>

#include "raster/image_error.h"
#include "raster/load_image.h"

// libFuzzer: any bytes are a picture or an ImageError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        scanlight::raster::decode_image({"fuzz", {bytes, bytes + size}});
    } catch (const scanlight::raster::ImageError&) {
    }
    return 0;
}
