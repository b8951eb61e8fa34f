#include "raster/byte_cursor.h"

#include <charconv>

#include "raster/image_error.h"

namespace scanlight::raster {

std::span<const std::uint8_t> ByteCursor::take(std::size_t count) {
    if (count > bytes_left()) fail("the file ends too early");
    const auto taken = std::span(file_->bytes).subspan(at_, count);
    at_ += count;
    return taken;
}

std::string_view ByteCursor::word() {
    skip_spaces_and_comments();
    const std::size_t begin = at_;
    while (bytes_left() > 0 && !at_space())
        ++at_;
    return text_from(begin);
}

std::int64_t ByteCursor::number() {
    const std::string_view digits = word();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
        fail("the header lacks a whole number");
    }
    return value;
}

void ByteCursor::end_header() {
    if (bytes_left() == 0 || !at_space()) fail("the header does not end in white space");
    ++at_;
}

std::string_view ByteCursor::line() {
    const std::size_t begin = at_;
    while (next() != '\n') {
    }
    return text_from(begin).substr(0, at_ - begin - 1);
}

void ByteCursor::require_end() const {
    if (bytes_left() > 0) fail(std::to_string(bytes_left()) + " bytes follow the picture");
}

void ByteCursor::fail(const std::string& reason) const {
    throw ImageError(file_->name + ": " + reason);
}

bool ByteCursor::at_space() const {
    const std::uint8_t c = file_->bytes[at_];
    return c == ' ' || (c >= '\t' && c <= '\r');
}

void ByteCursor::skip_spaces_and_comments() {
    while (bytes_left() > 0) {
        if (file_->bytes[at_] == '#') {
            line();
        } else if (at_space()) {
            ++at_;
        } else {
            return;
        }
    }
}

std::string_view ByteCursor::text_from(std::size_t begin) const {
    return {reinterpret_cast<const char*>(file_->bytes.data()) + begin, at_ - begin};
}

}  // namespace scanlight::raster
