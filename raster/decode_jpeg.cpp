#include "raster/decode_jpeg.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>  // jpeglib.h needs it
#include <string>

#include <jerror.h>
#include <jpeglib.h>

#include "raster/image_error.h"
#include "raster/image_limits.h"

namespace scanlight::raster {

namespace {

// libjpeg wants to end the program when something is wrong; we leave by longjmp instead. Nothing
// that has a destructor may live in the functions it jumps out of: they work on what a Reader and
// its user own.

// A picture is refined in some ten scans; thousands of them cost minutes and add nothing.
constexpr int max_scans = 100;

// What libjpeg calls back, and what went wrong, kept where a jump can't hurt it.
struct Errors {
    jpeg_error_mgr manager;  // first: libjpeg knows only this part
    std::jmp_buf out;
    std::array<char, JMSG_LENGTH_MAX> reason;
};

Errors& errors_of(j_common_ptr jpeg) {
    return *reinterpret_cast<Errors*>(jpeg->err);
}

[[noreturn]] void jump_out(j_common_ptr jpeg) {
    Errors& errors = errors_of(jpeg);
    errors.manager.format_message(jpeg, errors.reason.data());
    std::longjmp(errors.out, 1);
}

[[noreturn]] void jump_out(j_common_ptr jpeg, const char* reason) {
    Errors& errors = errors_of(jpeg);
    std::snprintf(errors.reason.data(), errors.reason.size(), "%s", reason);
    std::longjmp(errors.out, 1);
}

// Bytes too many between two segments, and odd version numbers, change no pixel.
bool is_harmless(int code) {
    return code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR || code == JWRN_ADOBE_XFORM;
}

// Level -1 is a warning: the data are damaged, and libjpeg would guess. Others are chatter.
void refuse_damage(j_common_ptr jpeg, int level) {
    const int code = jpeg->err->msg_code;
    if (level >= 0 || is_harmless(code)) return;
    if (code == JWRN_JPEG_EOF) jump_out(jpeg, "the file ends too early");
    jump_out(jpeg);
}

void say_nothing(j_common_ptr) {}

void refuse_endless_scans(j_common_ptr jpeg) {
    const auto& input = *reinterpret_cast<j_decompress_ptr>(jpeg);
    if (input.input_scan_number > max_scans) jump_out(jpeg, "it has too many scans");
}

// Runs `steps`; false when libjpeg jumped out of them.
template <class Steps>
bool completes(Errors& errors, const Steps& steps) {
    if (setjmp(errors.out) != 0) return false;
    steps();
    return true;
}

// libjpeg's state for one picture.
struct Reader {
    Reader() {
        jpeg.err = jpeg_std_error(&errors.manager);
        errors.manager.error_exit = jump_out;
        errors.manager.emit_message = refuse_damage;
        errors.manager.output_message = say_nothing;
        progress.progress_monitor = refuse_endless_scans;
    }
    ~Reader() { jpeg_destroy_decompress(&jpeg); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    template <class Steps>
    void run(const std::string& name, const Steps& steps) {
        if (!completes(errors, steps)) throw ImageError(name + ": " + errors.reason.data());
    }

    Errors errors{};
    jpeg_progress_mgr progress{};
    jpeg_decompress_struct jpeg{};  // zero: may be destroyed before it is created
};

void read_header(Reader& reader, const EncodedImage& file) {
    auto& jpeg = reader.jpeg;
    jpeg_create_decompress(&jpeg);
    jpeg.progress = &reader.progress;
    jpeg_mem_src(&jpeg, file.bytes.data(), static_cast<unsigned long>(file.bytes.size()));
    jpeg_read_header(&jpeg, TRUE);
}

void require_readable(const std::string& name, const jpeg_decompress_struct& jpeg) {
    const auto refuse = [&](const std::string& reason) { throw ImageError(name + ": " + reason); };
    if (jpeg.data_precision != 8)
        refuse(std::to_string(jpeg.data_precision) + " bits a sample; only 8 are read");
    if (jpeg.arith_code != 0) refuse("arithmetic coding is not read; Huffman's is");
    if (jpeg.jpeg_color_space == JCS_UNKNOWN)
        refuse(std::to_string(jpeg.num_components) + " channels; 1, 3 or 4 are read");
}

// Each block of 8 x 8 samples takes a bit at least, and the finest channel may have a quarter of
// the picture's blocks: a few bytes can't claim many pixels.
void require_believable(const EncodedImage& file, const jpeg_decompress_struct& jpeg) {
    const std::int64_t width = jpeg.image_width;
    const std::int64_t height = jpeg.image_height;
    require_within_limits(file.name, {width, height, jpeg.num_components});
    if (width * height / (64 * 4 * 8) > static_cast<std::int64_t>(file.bytes.size())) {
        throw ImageError(file.name + ": the file ends too early");
    }
}

// Whatever could differ between versions and processors is decided here.
void fix_settings(jpeg_decompress_struct& jpeg) {
    constexpr J_COLOR_SPACE spaces[] = {JCS_UNKNOWN, JCS_GRAYSCALE, JCS_UNKNOWN, JCS_RGB, JCS_CMYK};
    jpeg.out_color_space = spaces[jpeg.num_components];
    jpeg.dct_method = JDCT_ISLOW;
    jpeg.do_fancy_upsampling = FALSE;
    jpeg.do_block_smoothing = FALSE;
}

Image8 read_samples(Reader& reader, const std::string& name) {
    auto& jpeg = reader.jpeg;
    Image8 image(static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height),
                 jpeg.num_components);
    reader.run(name, [&] {
        fix_settings(jpeg);
        jpeg_start_decompress(&jpeg);
        while (jpeg.output_scanline < jpeg.output_height) {
            JSAMPROW row = image.row(static_cast<int>(jpeg.output_scanline)).data();
            jpeg_read_scanlines(&jpeg, &row, 1);
        }
        jpeg_finish_decompress(&jpeg);
    });
    return image;
}

std::uint8_t product(int a, int b) {
    return static_cast<std::uint8_t>((a * b + 127) / 255);
}

// Paper that is left white by ink and by black. Adobe's programs write 255 for no ink.
Image8 without_ink(const Image8& ink, bool is_inverted) {
    Image8 image(ink.width(), ink.height(), 3);
    const auto white = [&](std::uint8_t sample) { return is_inverted ? sample : 255 - sample; };
    for (int y = 0; y < ink.height(); ++y) {
        for (int x = 0; x < ink.width(); ++x) {
            const auto from = ink.pixel(x, y);
            std::ranges::transform(from.first(3), image.pixel(x, y).begin(), [&](auto sample) {
                return product(white(sample), white(from[3]));
            });
        }
    }
    return image;
}

}  // namespace

Image8 decode_jpeg(const EncodedImage& file) {
    Reader reader;
    reader.run(file.name, [&] { read_header(reader, file); });
    require_readable(file.name, reader.jpeg);
    require_believable(file, reader.jpeg);
    const Image8 image = read_samples(reader, file.name);
    if (image.channels() < 4) return image;
    return without_ink(image, reader.jpeg.saw_Adobe_marker != 0);
}

}  // namespace scanlight::raster
