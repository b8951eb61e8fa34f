#include "raster/hdr.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "raster/byte_cursor.h"
#include "raster/image_limits.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace scanlight::raster {

namespace {

constexpr float largest_light = 0xffp119f;  // mantissa 255, exponent 255: 255/256 · 2^127

// stb converts to bytes without a look at the range.
float within_range(float light) {
    return light > 0 ? std::min(light, largest_light) : 0;  // NaN too
}

ImageF within_range(const ImageF& image) {
    ImageF tame(image.width(), image.height(), image.channels());
    std::ranges::transform(image.samples(), tame.samples().begin(),
                           [](float light) { return within_range(light); });
    return tame;
}

void append(void* bytes, void* data, int size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    static_cast<Bytes*>(bytes)->insert(static_cast<Bytes*>(bytes)->end(), first, first + size);
}

struct Size {
    std::int64_t width;
    std::int64_t height;
};

void read_magic(ByteCursor& cursor) {
    const std::string_view magic = cursor.line();
    if (magic != "#?RADIANCE" && magic != "#?RGBE") cursor.fail("not a Radiance HDR file");
}

// Variables, one a line, up to an empty line.
void read_variables(ByteCursor& cursor) {
    for (std::string_view line = cursor.line(); !line.empty(); line = cursor.line()) {
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
            cursor.fail("of Radiance's formats only 32-bit_rle_rgbe is read");
        }
    }
}

Size read_size(ByteCursor& cursor) {
    Size size{};
    if (cursor.word() != "-Y") cursor.fail("rows that do not run from the top down are not read");
    size.height = cursor.number();
    if (cursor.word() != "+X") cursor.fail("columns that do not run to the right are not read");
    size.width = cursor.number();
    cursor.end_header();
    return size;
}

using Rgbe = std::array<std::uint8_t, 4>;

// A row is run-length coded when it begins like this; as a pixel it would not be normalised.
bool begins_coded_row(const Rgbe& rgbe, std::size_t width) {
    return width >= 8 && rgbe[0] == 2 && rgbe[1] == 2 && rgbe[2] < 128;
}

Rgbe take_rgbe(ByteCursor& cursor) {
    const auto bytes = cursor.take(4);
    return {bytes[0], bytes[1], bytes[2], bytes[3]};
}

std::size_t run_length(const ByteCursor& cursor, int length, std::size_t room) {
    if (length == 0) cursor.fail("a run of no pixels");
    if (static_cast<std::size_t>(length) > room) cursor.fail("a run passes the end of its row");
    return static_cast<std::size_t>(length);
}

// One of the four components of a coded row. A count above 128 repeats the byte that follows, any
// other announces so many bytes.
void read_component(ByteCursor& cursor, std::vector<Rgbe>& row, std::size_t component) {
    for (std::size_t x = 0; x < row.size();) {
        const int count = cursor.next();
        const bool repeats = count > 128;
        const std::size_t end =
            x + run_length(cursor, repeats ? count - 128 : count, row.size() - x);
        const auto bytes = cursor.take(repeats ? 1 : end - x);
        for (std::size_t i = 0; x < end; ++x, ++i)
            row[x][component] = bytes[repeats ? 0 : i];
    }
}

void read_flat_row(ByteCursor& cursor, std::vector<Rgbe>& row, const Rgbe& first) {
    row[0] = first;
    for (std::size_t x = 1; x < row.size(); ++x)
        row[x] = take_rgbe(cursor);
    const bool old_runs =
        std::ranges::any_of(row, [](Rgbe c) { return c[0] == 1 && c[1] == 1 && c[2] == 1; });
    if (old_runs) cursor.fail("old run-length coding is not read");
}

void read_coded_row(ByteCursor& cursor, std::vector<Rgbe>& row, const Rgbe& start) {
    if (static_cast<std::size_t>(start[2] << 8 | start[3]) != row.size()) {
        cursor.fail("a row is not as wide as the picture");
    }
    for (std::size_t component = 0; component < 4; ++component) {
        read_component(cursor, row, component);
    }
}

void read_row(ByteCursor& cursor, std::vector<Rgbe>& row) {
    const Rgbe first = take_rgbe(cursor);
    if (begins_coded_row(first, row.size())) {
        read_coded_row(cursor, row, first);
    } else {
        read_flat_row(cursor, row, first);
    }
}

// ldexp is exact: 8 bits of mantissa, and the smallest exponent still is a denormal float.
void store(const Rgbe& rgbe, std::span<float> pixel) {
    for (std::size_t c = 0; c < 3; ++c) {
        pixel[c] = rgbe[3] == 0 ? 0 : std::ldexp(static_cast<float>(rgbe[c]), rgbe[3] - 136);
    }
}

// The shortest row, coded in runs of 127, or flat where it is too narrow to be coded.
std::size_t fewest_bytes(const Size& size) {
    const std::int64_t row =
        size.width < 8 ? 4 * size.width : 4 + 4 * 2 * ((size.width + 126) / 127);
    return static_cast<std::size_t>(row * size.height);
}

}  // namespace

Bytes encode_hdr(const ImageF& image) {
    assert(image.channels() == 1 || image.channels() == 3);
    const ImageF tame = within_range(image);
    Bytes bytes;
    stbi_write_hdr_to_func(append, &bytes, tame.width(), tame.height(), tame.channels(),
                           tame.samples().data());
    return bytes;
}

ImageF decode_hdr(const EncodedImage& file) {
    ByteCursor cursor(file);
    read_magic(cursor);
    read_variables(cursor);
    const Size size = read_size(cursor);
    require_within_limits(file.name, {size.width, size.height, 3 * sizeof(float)});
    if (cursor.bytes_left() < fewest_bytes(size)) cursor.fail("the file ends too early");
    ImageF image(static_cast<int>(size.width), static_cast<int>(size.height), 3);
    std::vector<Rgbe> row(static_cast<std::size_t>(size.width));
    for (int y = 0; y < image.height(); ++y) {
        read_row(cursor, row);
        for (int x = 0; x < image.width(); ++x) {
            store(row[static_cast<std::size_t>(x)], image.pixel(x, y));
        }
    }
    cursor.require_end();
    return image;
}

}  // namespace scanlight::raster
