#include "raster/pfm.h"

#include <bit>
#include <cassert>
#include <charconv>
#include <string>
#include <string_view>

#include "raster/byte_cursor.h"
#include "raster/image_limits.h"

namespace scanlight::raster {

namespace {

std::string header_of(const ImageF& image) {
    assert(image.channels() == 1 || image.channels() == 3);
    return std::string(image.channels() == 1 ? "Pf" : "PF") + "\n" + std::to_string(image.width()) +
           " " + std::to_string(image.height()) + "\n-1.0\n";
}

void append(Bytes& bytes, float sample) {
    const auto bits = std::bit_cast<std::uint32_t>(sample);
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(bits >> shift & 0xff));
    }
}

int channels_of(const ByteCursor& cursor, std::string_view magic) {
    if (magic == "Pf") return 1;
    if (magic == "PF") return 3;
    cursor.fail("not a PFM file");
}

std::endian byte_order(const ByteCursor& cursor, std::string_view scale) {
    float value = 0;
    const auto [end, error] = std::from_chars(scale.data(), scale.data() + scale.size(), value);
    if (error != std::errc() || end != scale.data() + scale.size() || !(value < 0 || value > 0)) {
        cursor.fail("the scale is not a number other than 0");
    }
    return value < 0 ? std::endian::little : std::endian::big;
}

struct Header {
    std::int64_t width;
    std::int64_t height;
    int channels;
    std::endian order;
};

Header read_header(ByteCursor& cursor) {
    Header header{};
    header.channels = channels_of(cursor, cursor.word());
    header.width = cursor.number();
    header.height = cursor.number();
    header.order = byte_order(cursor, cursor.word());
    cursor.end_header();
    return header;
}

float take_float(ByteCursor& cursor, std::endian order) {
    const auto bytes = cursor.take(4);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        bits = bits << 8 | bytes[order == std::endian::big ? i : 3 - i];
    }
    return std::bit_cast<float>(bits);
}

}  // namespace

Bytes encode_pfm(const ImageF& image) {
    const std::string header = header_of(image);
    Bytes bytes(header.begin(), header.end());
    bytes.reserve(header.size() + image.samples().size_bytes());
    for (int y = image.height() - 1; y >= 0; --y) {
        for (const float sample : image.row(y))
            append(bytes, sample);
    }
    return bytes;
}

ImageF decode_pfm(const EncodedImage& file) {
    ByteCursor cursor(file);
    const Header header = read_header(cursor);
    const std::int64_t bytes_per_pixel = header.channels * 4;
    require_within_limits(file.name, {header.width, header.height, bytes_per_pixel});
    const auto size = static_cast<std::size_t>(header.width * header.height * bytes_per_pixel);
    if (cursor.bytes_left() < size) cursor.fail("the file ends too early");
    ImageF image(static_cast<int>(header.width), static_cast<int>(header.height), header.channels);
    for (int y = image.height() - 1; y >= 0; --y) {
        for (float& sample : image.row(y))
            sample = take_float(cursor, header.order);
    }
    cursor.require_end();
    return image;
}

}  // namespace scanlight::raster
