#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "raster/encoded_image.h"

namespace scanlight::raster {

/// Walks the bytes of an image file from first to last; every step past the end throws ImageError.
/// Invariant: at_ <= size of the file. The file outlives the cursor.
class ByteCursor {
public:
    explicit ByteCursor(const EncodedImage& file) : file_(&file) {}

    std::size_t bytes_left() const noexcept { return file_->bytes.size() - at_; }

    std::uint8_t next() { return take(1)[0]; }

    /// The next `count` bytes.
    std::span<const std::uint8_t> take(std::size_t count);

    /// Text up to the next white space, which stays; white space and # comments before it go.
    std::string_view word();

    /// A whole decimal number, negative ones too, read as a word.
    std::int64_t number();

    /// The one white-space character that ends a Netpbm or PFM header.
    void end_header();

    /// Text up to the next line feed, which goes too.
    std::string_view line();

    /// Refuses a file that goes on where its picture ends.
    void require_end() const;

    /// Throws ImageError "name: reason".
    [[noreturn]] void fail(const std::string& reason) const;

private:
    bool at_space() const;
    void skip_spaces_and_comments();
    std::string_view text_from(std::size_t begin) const;

    const EncodedImage* file_;
    std::size_t at_ = 0;
};

}  // namespace scanlight::raster
