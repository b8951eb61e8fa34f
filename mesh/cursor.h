#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh/text.h"

namespace scanlight::mesh {

/// What a text format means by a line.
struct LineRules {
    bool hash_comments = false;    // '#' starts a comment, to the end of the line
    bool continued_lines = false;  // '\' before a line end joins the next line to this one
};

/// A place in the text of a file, and the verbs that read on from it. LF, CR and CRLF end a line.
/// The locale has no say. Invariant: begin_ <= here_ <= end_, so no verb reads past the bytes.
/// Lines are counted only when a message needs one.
class Cursor {
public:
    /// `bytes` must outlive the cursor; `name` is the file's, for messages.
    Cursor(std::string_view bytes, std::string name, LineRules rules = {});

    bool at_end() const { return here_ == end_; }
    std::size_t offset() const { return static_cast<std::size_t>(here_ - begin_); }
    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - here_); }
    const std::string& name() const { return name_; }

    /// Steps over blanks; true at the end of the line, at a comment, and at the end of the file.
    bool at_line_end() {
        skip_blanks();
        return at_end() || is_line_end(*here_) || at_comment();
    }

    /// Goes to a byte that another reader found.
    void seek(std::size_t offset) { here_ = begin_ + offset; }

    /// Leaves the rest of this line.
    void next_line();

    /// Steps over blanks, line ends and comments, to the next word of the file.
    void skip_space();

    /// The next word of this line; empty at its end.
    std::string_view word();

    /// What is left of this line, without blanks around it, comments and all.
    std::string_view rest_of_line();

    /// Steps over `text` if it comes next on this line, in any case of letters.
    bool accept(std::string_view text);

    /// Whether `c` comes next, without a blank before it; if so, steps over it.
    bool accept_here(char c) {
        if (at_end() || *here_ != c) return false;
        ++here_;
        return true;
    }

    /// The next number of this line, finite. Fails if there is none.
    double number();

    /// The same, finite as a float too.
    float single();

    /// The next integer of this line, or, for `_here`, with no blank before it and whatever after
    /// it. Fails if there is none.
    std::int64_t integer();
    std::int64_t integer_here();

    /// Whether an integer starts right here.
    bool integer_follows() const {
        return !at_end() && (is_digit(*here_) || *here_ == '-' || *here_ == '+');
    }

    /// Whether no word goes on here.
    bool at_word_end() const {
        return at_end() || is_space(*here_) || at_comment() || at_continuation();
    }

    /// The text from `offset` to here.
    std::string_view since(std::size_t offset) const { return {begin_ + offset, here_}; }

    /// "name:line", of this place.
    std::string where() const { return where(offset()); }
    std::string where(std::size_t offset) const;

    /// Throws FileError "name:line: reason", with the line of this place or of `offset`.
    [[noreturn]] void fail(const std::string& reason) const;
    [[noreturn]] void fail_at(std::size_t offset, const std::string& reason) const;

    /// The same, the reason being the word that starts here, in quotes, and the complaint.
    [[noreturn]] void fail_at_word(std::string_view complaint) const;

private:
    static bool is_digit(char c) { return '0' <= c && c <= '9'; }
    bool at_comment() const { return rules_.hash_comments && *here_ == '#'; }
    bool at_continuation() const {
        return rules_.continued_lines && *here_ == '\\' && here_ + 1 != end_ &&
               is_line_end(here_[1]);
    }
    void skip_blanks() {
        while (!at_end() && (is_blank(*here_) || at_continuation())) {
            if (!is_blank(*here_++)) skip_line_end();
        }
    }
    void skip_line_end();
    std::string_view word_here() const;
    const char* after_plus() const;  // from_chars takes no plus sign

    const char* begin_;
    const char* end_;
    const char* here_;
    std::string name_;
    LineRules rules_;
};

/// Fails if the bytes hold a NUL: such a file is no text, whatever its ending says.
void expect_text(const Cursor& cursor, std::string_view bytes);

}  // namespace scanlight::mesh
