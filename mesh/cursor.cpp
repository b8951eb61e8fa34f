#include "mesh/cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include "mesh/file_error.h"

namespace scanlight::mesh {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::size_t lines_ended(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool half_of_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
        if (is_line_end(text[i]) && !half_of_crlf) ++count;
    }
    return count;
}

}  // namespace

Cursor::Cursor(std::string_view bytes, std::string name, LineRules rules)
    : begin_(bytes.data()),
      end_(bytes.data() + bytes.size()),
      here_(begin_),
      name_(std::move(name)),
      rules_(rules) {
    if (bytes.starts_with(byte_order_mark)) here_ += byte_order_mark.size();
}

void Cursor::next_line() {
    here_ = std::find_if(here_, end_, is_line_end);
    skip_line_end();
}

void Cursor::skip_line_end() {
    if (at_end()) return;
    const char first = *here_++;
    if (first == '\r' && !at_end() && *here_ == '\n') ++here_;
}

void Cursor::skip_space() {
    while (at_line_end() && !at_end())
        next_line();
}

std::string_view Cursor::word_here() const {
    const char* stop = here_;
    while (stop != end_ && !is_space(*stop))
        ++stop;
    return {here_, stop};
}

std::string_view Cursor::word() {
    if (at_line_end()) return {};
    const char* first = here_;
    while (!at_word_end())
        ++here_;
    return {first, here_};
}

std::string_view Cursor::rest_of_line() {
    const char* first = here_;
    here_ = std::find_if(here_, end_, is_line_end);
    return trimmed({first, here_});
}

bool Cursor::accept(std::string_view text) {
    skip_blanks();
    if (bytes_left() < text.size() || !equal_ignoring_case({here_, text.size()}, text)) {
        return false;
    }
    here_ += text.size();
    return true;
}

const char* Cursor::after_plus() const {
    const bool plus = bytes_left() > 1 && here_[0] == '+' && here_[1] != '-';
    return plus ? here_ + 1 : here_;
}

double Cursor::number() {
    if (at_line_end()) fail("a number is missing");
    double value = 0;
    const auto [stop, error] = std::from_chars(after_plus(), end_, value);
    if (error == std::errc::result_out_of_range) fail_at_word("is out of range");
    if (error != std::errc{}) fail_at_word("is not a number");
    if (!std::isfinite(value)) fail_at_word("is not a finite number");
    const char* const start = std::exchange(here_, stop);
    if (!at_word_end()) {
        here_ = start;
        fail_at_word("is not a number");
    }
    return value;
}

float Cursor::single() {
    const char* const start = here_;
    const double value = number();
    if (std::abs(value) > double{std::numeric_limits<float>::max()}) {
        here_ = start;
        skip_blanks();
        fail_at_word("is out of range");
    }
    // Rounds twice, which 9 decimal digits cannot tell from once.
    return static_cast<float>(value);
}

std::int64_t Cursor::integer_here() {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(after_plus(), end_, value);
    if (error == std::errc::result_out_of_range) fail_at_word("is out of range");
    if (error != std::errc{}) fail_at_word("is not an integer");
    here_ = stop;
    return value;
}

std::int64_t Cursor::integer() {
    if (at_line_end()) fail("a number is missing");
    const char* const start = here_;
    const std::int64_t value = integer_here();
    if (!at_word_end()) {
        here_ = start;
        fail_at_word("is not an integer");
    }
    return value;
}

std::string Cursor::where(std::size_t offset) const {
    const std::size_t line = 1 + lines_ended({begin_, offset});
    return name_ + ":" + std::to_string(line);
}

void Cursor::fail_at(std::size_t offset, const std::string& reason) const {
    throw FileError(where(offset) + ": " + reason);
}

void Cursor::fail(const std::string& reason) const {
    fail_at(offset(), reason);
}

void Cursor::fail_at_word(std::string_view complaint) const {
    fail(quoted(word_here()) + " " + std::string(complaint));
}

void expect_text(const Cursor& cursor, std::string_view bytes) {
    const std::size_t zero = bytes.find('\0');
    if (zero != bytes.npos) cursor.fail_at(zero, "a zero byte: this is not a text file");
}

}  // namespace scanlight::mesh
