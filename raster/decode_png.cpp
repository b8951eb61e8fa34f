#include "raster/decode_png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "raster/image_error.h"
#include "raster/image_limits.h"

namespace scanlight::raster {

namespace {

// libpng leaves by longjmp when something is wrong. Nothing that has a destructor may live in the
// functions it jumps out of: they work on what a Reader and its user own.

// What went wrong, kept where a jump can't hurt it.
using Reason = std::array<char, 128>;

[[noreturn]] void jump_out(png_structp png, png_const_charp text) {
    auto& reason = *static_cast<Reason*>(png_get_error_ptr(png));
    const std::size_t length = std::min(std::string_view(text).size(), reason.size() - 1);
    *std::copy_n(text, length, reason.begin()) = '\0';
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// Runs `steps`; false when libpng jumped out of them.
template <class Steps>
bool completes(png_structp png, const Steps& steps) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    steps();
    return true;
}

// libpng's state for one picture. Null pointers mean that there was no memory for it.
struct Reader {
    Reader() {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reason, jump_out, ignore_warning);
        if (png != nullptr) info = png_create_info_struct(png);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    template <class Steps>
    void run(const std::string& name, const Steps& steps) {
        if (info == nullptr || !completes(png, steps)) {
            throw ImageError(name + ": " + reason.data());
        }
    }

    Reason reason{"out of memory"};
    png_structp png = nullptr;
    png_infop info = nullptr;
};

// PNG is big endian; libpng swaps when told.
void keep_native_order(png_structp png, int bit_depth) {
    if (bit_depth == 16 && std::endian::native == std::endian::little) png_set_swap(png);
}

template <class Sample>
std::vector<png_bytep> rows_of(Image<Sample>& image) {
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.height(); ++y) {
        rows.push_back(reinterpret_cast<png_bytep>(image.row(y).data()));
    }
    return rows;
}

struct Input {
    std::span<const std::uint8_t> left;
};

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto& input = *static_cast<Input*>(png_get_io_ptr(png));
    if (count > input.left.size()) png_error(png, "the file ends too early");
    std::copy_n(input.left.begin(), count, to);
    input.left = input.left.subspan(count);
}

// What the header declares: of the picture in memory, and how many bytes its rows unpack to.
struct Layout {
    std::int64_t width = 0;
    std::int64_t height = 0;
    int channels = 0;
    int bit_depth = 0;
    std::int64_t unpacked_bytes = 0;
};

// Texts, profiles and the like change no pixel, and could unpack to gigabytes.
void ignore_side_notes(png_structp png) {
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
}

Layout read_layout(png_structp png, png_infop info) {
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    ignore_side_notes(png);
    png_read_info(png, info);
    Layout layout;
    layout.width = png_get_image_width(png, info);
    layout.height = png_get_image_height(png, info);
    layout.unpacked_bytes = static_cast<std::int64_t>(png_get_rowbytes(png, info)) * layout.height;
    png_set_expand(png);
    keep_native_order(png, png_get_bit_depth(png, info));
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    layout.channels = png_get_channels(png, info);
    layout.bit_depth = png_get_bit_depth(png, info);
    return layout;
}

// Deflate packs at most 1032 bytes into one: a few bytes can't claim many pixels.
void require_believable(const EncodedImage& file, const Layout& layout) {
    require_within_limits(file.name,
                          {layout.width, layout.height, layout.channels * (layout.bit_depth / 8)});
    if (layout.unpacked_bytes / 1032 > static_cast<std::int64_t>(file.bytes.size())) {
        throw ImageError(file.name + ": the file ends too early");
    }
}

template <class Sample>
Image<Sample> read_pixels(Reader& reader, const std::string& name, const Layout& layout) {
    Image<Sample> image(static_cast<int>(layout.width), static_cast<int>(layout.height),
                        layout.channels);
    std::vector<png_bytep> rows = rows_of(image);
    reader.run(name, [&] {
        png_read_image(reader.png, rows.data());
        png_read_end(reader.png, nullptr);
    });
    return image;
}

}  // namespace

AnyImage decode_png(const EncodedImage& file) {
    Reader reader;
    Input input{file.bytes};
    Layout layout;
    reader.run(file.name, [&] {
        png_set_read_fn(reader.png, &input, read_bytes);
        layout = read_layout(reader.png, reader.info);
    });
    require_believable(file, layout);
    if (layout.bit_depth == 16) return read_pixels<std::uint16_t>(reader, file.name, layout);
    return read_pixels<std::uint8_t>(reader, file.name, layout);
}

}  // namespace scanlight::raster
