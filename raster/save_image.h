#pragma once

#include <string>

#include "raster/image.h"

namespace scanlight::raster {

enum class ImageFormat {
    png,  // 8 or 16 bits
    pnm,  // 8 or 16 bits, no alpha
    pfm,  // float, no alpha
    hdr,  // float, about 8 bits of it, no alpha
};

/// The format that the ending of `path` names, in any case: .png, .ppm, .pgm, .pfm, .hdr. "-",
/// standard output, takes PPM. Throws ImageError listing the endings for any other.
ImageFormat image_format(const std::string& path);

/// Whether the ending of `path` is Netpbm's for grey alone, .pgm.
bool promises_grey(const std::string& path);

/// Whether its samples are floats; all others hold whole numbers.
bool holds_floats(ImageFormat format);
bool holds_alpha(ImageFormat format);

/// Writes a picture, whole or not at all (see save_file). Throws ImageError: it can't be written,
/// it has no pixels, or the format holds no such samples or channels.
void save_image(const std::string& path, const AnyImage& image, ImageFormat format);
void save_image(const std::string& path, const AnyImage& image);

}  // namespace scanlight::raster
