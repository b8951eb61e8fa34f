#include "raster/pnm.h"

#include <cassert>
#include <string>
#include <string_view>

#include "raster/byte_cursor.h"
#include "raster/image_limits.h"

namespace scanlight::raster {

namespace {

void append(Bytes& bytes, std::uint8_t sample) {
    bytes.push_back(sample);
}

void append(Bytes& bytes, std::uint16_t sample) {
    bytes.push_back(static_cast<std::uint8_t>(sample >> 8));
    bytes.push_back(static_cast<std::uint8_t>(sample & 0xff));
}

template <class Sample>
std::string header_of(const Image<Sample>& image) {
    assert(image.channels() == 1 || image.channels() == 3);
    return std::string(image.channels() == 1 ? "P5" : "P6") + "\n" + std::to_string(image.width()) +
           " " + std::to_string(image.height()) + "\n" + (sizeof(Sample) == 1 ? "255" : "65535") +
           "\n";
}

template <class Sample>
Bytes encode(const Image<Sample>& image) {
    const std::string header = header_of(image);
    Bytes bytes(header.begin(), header.end());
    bytes.reserve(header.size() + image.samples().size_bytes());
    for (const Sample sample : image.samples())
        append(bytes, sample);
    return bytes;
}

void take(ByteCursor& cursor, std::uint8_t& sample) {
    sample = cursor.next();
}

void take(ByteCursor& cursor, std::uint16_t& sample) {
    const auto bytes = cursor.take(2);
    sample = static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
}

struct Header {
    std::int64_t width;
    std::int64_t height;
    int channels;
    std::int64_t max_value;
};

int channels_of(const ByteCursor& cursor, std::string_view magic) {
    if (magic == "P5") return 1;
    if (magic == "P6") return 3;
    cursor.fail("of Netpbm only the binary P5 and P6 are read");
}

Header read_header(ByteCursor& cursor) {
    Header header{};
    header.channels = channels_of(cursor, cursor.word());
    header.width = cursor.number();
    header.height = cursor.number();
    header.max_value = cursor.number();
    cursor.end_header();
    if (header.max_value != 255 && header.max_value != 65535) {
        cursor.fail("maxval " + std::to_string(header.max_value) + ": only 255 and 65535 are read");
    }
    return header;
}

// The bytes are known to be there before the picture is made.
template <class Sample>
Image<Sample> read_samples(ByteCursor& cursor, const Header& header, const std::string& name) {
    const auto bytes_per_pixel = header.channels * static_cast<std::int64_t>(sizeof(Sample));
    require_within_limits(name, {header.width, header.height, bytes_per_pixel});
    const auto size = static_cast<std::size_t>(header.width * header.height * bytes_per_pixel);
    if (cursor.bytes_left() < size) cursor.fail("the file ends too early");
    Image<Sample> image(static_cast<int>(header.width), static_cast<int>(header.height),
                        header.channels);
    for (Sample& sample : image.samples())
        take(cursor, sample);
    cursor.require_end();
    return image;
}

}  // namespace

Bytes encode_pnm(const Image8& image) {
    return encode(image);
}

Bytes encode_pnm(const Image16& image) {
    return encode(image);
}

AnyImage decode_pnm(const EncodedImage& file) {
    ByteCursor cursor(file);
    const Header header = read_header(cursor);
    if (header.max_value == 255) return read_samples<std::uint8_t>(cursor, header, file.name);
    return read_samples<std::uint16_t>(cursor, header, file.name);
}

}  // namespace scanlight::raster
