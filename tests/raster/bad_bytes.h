#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>

#include "raster/image_error.h"
#include "raster/load_image.h"

namespace scanlight::raster {

inline EncodedImage file_of(std::string_view bytes) {
    return {"picture", Bytes(bytes.begin(), bytes.end())};
}

/// What the reader says about a bad file; empty when it takes it.
inline std::string complaint(const EncodedImage& file) {
    try {
        decode_image(file);
        return {};
    } catch (const ImageError& error) {
        return error.what();
    }
}

/// Every beginning of a file that lacks a byte is refused, by name.
inline void expect_no_beginning_is_read(const Bytes& whole) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const EncodedImage file{"cut", {whole.begin(), whole.begin() + std::ptrdiff_t(size)}};
        EXPECT_TRUE(complaint(file).starts_with("cut: ")) << size << " of " << whole.size();
    }
}

/// A file with a few bits turned is read or refused; nothing else may happen. Counts the refused.
inline int refused_of_damaged(const Bytes& whole, int files, unsigned seed) {
    std::mt19937 random(seed);
    int refused = 0;
    for (int i = 0; i < files; ++i) {
        EncodedImage file{"damaged", whole};
        for (int bits = 1 + i % 4; bits > 0; --bits) {
            file.bytes[random() % whole.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
        }
        refused += complaint(file).empty() ? 0 : 1;
    }
    return refused;
}

}  // namespace scanlight::raster
