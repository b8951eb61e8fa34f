#pragma once

#include <cstdint>
#include <string>

#include "raster/encoded_image.h"

namespace scanlight::raster {

/// PNG files made byte by byte, with right checksums, so that what is inside can be wrong.

inline std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xffffffff;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ (crc % 2 == 1 ? 0xedb88320 : 0);
    }
    return ~crc;
}

inline std::uint32_t adler32(const std::string& bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<std::uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

inline std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
    const auto size = static_cast<std::uint32_t>(data.size());
    return big_endian(size) + type + data + big_endian(crc32(type + data));
}

/// A zlib stream of one stored block; up to 65535 bytes.
inline std::string stored(const std::string& bytes) {
    const auto low = static_cast<char>(bytes.size() & 0xff);
    const auto high = static_cast<char>(bytes.size() >> 8);
    const std::string sizes{low, high, static_cast<char>(~low), static_cast<char>(~high)};
    return std::string("\x78\x01\x01") + sizes + bytes + big_endian(adler32(bytes));
}

/// A zlib stream of 1 + 258 · `runs` letters A: one block of fixed codes, in it a literal and runs
/// of length 258 at distance 1 (RFC 1951, 3.2.6).
inline std::string packed_letters(std::size_t runs) {
    std::string bits =
        "110"
        "01110001";
    for (std::size_t i = 0; i < runs; ++i)
        bits +=
            "11000101"
            "00000";
    bits += "0000000";
    std::string bytes((bits.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i] == '1') bytes[i / 8] = static_cast<char>(bytes[i / 8] | 1 << i % 8);
    }
    return "\x78\x01" + bytes + big_endian(adler32(std::string(1 + 258 * runs, 'A')));
}

// Colour types.
inline constexpr unsigned grey = 0;
inline constexpr unsigned rgb = 2;
inline constexpr unsigned indexed = 3;

inline constexpr unsigned interlaced = 1;

struct PngHeader {
    std::uint32_t width;
    std::uint32_t height;
    unsigned bit_depth;
    unsigned colour_type;
    unsigned interlace = 0;
};

/// `rows` are as PNG packs them, each with its filter byte; `before` are chunks ahead of them.
inline EncodedImage handmade_png(const PngHeader& header, const std::string& rows,
                                 const std::string& before = {}) {
    const std::string kind{static_cast<char>(header.bit_depth),
                           static_cast<char>(header.colour_type), 0, 0,
                           static_cast<char>(header.interlace)};
    const std::string bytes =
        "\x89PNG\r\n\x1a\n" +
        png_chunk("IHDR", big_endian(header.width) + big_endian(header.height) + kind) + before +
        png_chunk("IDAT", stored(rows)) + png_chunk("IEND", "");
    return {"picture", Bytes(bytes.begin(), bytes.end())};
}

}  // namespace scanlight::raster
