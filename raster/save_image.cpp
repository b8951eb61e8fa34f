#include "raster/save_image.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

#include "raster/encode_png.h"
#include "raster/encoded_image.h"
#include "raster/hdr.h"
#include "raster/image_error.h"
#include "raster/pfm.h"
#include "raster/pnm.h"
#include "raster/save_file.h"

namespace scanlight::raster {

namespace {

struct Ending {
    std::string_view text;
    ImageFormat format;
};

constexpr std::array endings = {
    Ending{".png", ImageFormat::png}, Ending{".ppm", ImageFormat::pnm},
    Ending{".pgm", ImageFormat::pnm}, Ending{".pfm", ImageFormat::pfm},
    Ending{".hdr", ImageFormat::hdr},
};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool ends_in(std::string_view path, std::string_view ending) {
    return path.size() >= ending.size() &&
           std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, lower);
}

std::string known_endings() {
    std::string list;
    for (const Ending& ending : endings)
        list += " " + std::string(ending.text);
    return list;
}

bool has_floats(const AnyImage& image) {
    return std::holds_alternative<ImageF>(image);
}

bool has_alpha(const AnyImage& image) {
    return std::visit([](const auto& any) { return any.channels() % 2 == 0; }, image);
}

bool is_empty(const AnyImage& image) {
    return std::visit([](const auto& any) { return any.samples().empty(); }, image);
}

void require_fit(const std::string& path, const AnyImage& image, ImageFormat format) {
    if (is_empty(image)) throw ImageError(path + ": the picture has no pixels");
    if (has_floats(image) && !holds_floats(format)) {
        throw ImageError(path + ": this format holds whole numbers, the picture has floats");
    }
    if (!has_floats(image) && holds_floats(format)) {
        throw ImageError(path + ": this format holds floats, the picture has whole numbers");
    }
    if (has_alpha(image) && !holds_alpha(format)) {
        throw ImageError(path + ": this format holds no alpha channel");
    }
}

Bytes encode(const Image8& image, ImageFormat format) {
    return format == ImageFormat::png ? encode_png(image) : encode_pnm(image);
}

Bytes encode(const Image16& image, ImageFormat format) {
    return format == ImageFormat::png ? encode_png(image) : encode_pnm(image);
}

Bytes encode(const ImageF& image, ImageFormat format) {
    return format == ImageFormat::pfm ? encode_pfm(image) : encode_hdr(image);
}

}  // namespace

ImageFormat image_format(const std::string& path) {
    if (path == "-") return ImageFormat::pnm;
    for (const Ending& ending : endings) {
        if (ends_in(path, ending.text)) return ending.format;
    }
    throw ImageError(path +
                     ": unknown kind of picture; these endings are known:" + known_endings());
}

bool promises_grey(const std::string& path) {
    return ends_in(path, ".pgm");
}

bool holds_floats(ImageFormat format) {
    return format == ImageFormat::pfm || format == ImageFormat::hdr;
}

bool holds_alpha(ImageFormat format) {
    return format == ImageFormat::png;
}

void save_image(const std::string& path, const AnyImage& image, ImageFormat format) {
    require_fit(path, image, format);
    save_file(path, std::visit([&](const auto& any) { return encode(any, format); }, image));
}

void save_image(const std::string& path, const AnyImage& image) {
    save_image(path, image, image_format(path));
}

}  // namespace scanlight::raster
