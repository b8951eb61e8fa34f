#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh/cursor.h"
#include "mesh/load_number.h"
#include "mesh/ply_header.h"

namespace scanlight::mesh {

/// The numbers of a PLY body, one after the other, whatever their encoding. The two classes here
/// share their verbs, so that one template reads both.
///
/// Text: one record a line.
class PlyTextValues {
public:
    PlyTextValues(std::string_view bytes, const std::string& name, std::size_t header_size);

    std::size_t bytes_left() const { return text_.bytes_left(); }

    /// How many pieces of so many bytes there can be; the last need not end its line.
    std::size_t room_for(std::size_t size) const { return (bytes_left() + 1) / size; }
    void begin_record() { text_.skip_space(); }
    void end_record();

    /// The next number; fails where it does not fit its type.
    double value(PlyType type);

    void skip(PlyType type, std::uint64_t count);

    /// Fails where `count` numbers of `type` cannot be left.
    void expect_room(PlyType type, std::uint64_t count) const;

    /// Bytes after the last record that are more than blanks.
    std::size_t unread();

    [[noreturn]] void fail(const std::string& reason) const { text_.fail(reason); }

private:
    Cursor text_;
};

/// Binary: records without gaps, in the byte order `order`.
template <std::endian order>
class PlyBinaryValues {
public:
    PlyBinaryValues(std::string_view bytes, const std::string& name, std::size_t header_size)
        : begin_(bytes.data()),
          here_(begin_ + header_size),
          end_(begin_ + bytes.size()),
          name_(name) {}

    std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - here_); }
    std::size_t room_for(std::size_t size) const { return bytes_left() / size; }
    void begin_record() {}
    void end_record() {}
    double value(PlyType type);
    void skip(PlyType type, std::uint64_t count);
    void expect_room(PlyType type, std::uint64_t count) const {
        if (count > bytes_left() || count * size_of(type) > bytes_left()) fail_at_length(count);
    }
    std::size_t unread() const { return bytes_left(); }
    [[noreturn]] void fail(const std::string& reason) const;

private:
    template <class Number>
    double next();
    [[noreturn]] void fail_at_length(std::uint64_t count) const;

    const char* begin_;
    const char* here_;
    const char* end_;
    std::string name_;
};

template <std::endian order>
template <class Number>
inline double PlyBinaryValues<order>::next() {
    if (bytes_left() < sizeof(Number)) fail("the file ends too early");
    const auto number = load_number<Number, order>(here_);
    here_ += sizeof(Number);
    return static_cast<double>(number);
}

template <std::endian order>
inline double PlyBinaryValues<order>::value(PlyType type) {
    switch (type) {
        case PlyType::int8:
            return next<std::int8_t>();
        case PlyType::uint8:
            return next<std::uint8_t>();
        case PlyType::int16:
            return next<std::int16_t>();
        case PlyType::uint16:
            return next<std::uint16_t>();
        case PlyType::int32:
            return next<std::int32_t>();
        case PlyType::uint32:
            return next<std::uint32_t>();
        case PlyType::float32:
            return next<float>();
        case PlyType::float64:
            break;
    }
    return next<double>();
}

extern template class PlyBinaryValues<std::endian::little>;
extern template class PlyBinaryValues<std::endian::big>;

}  // namespace scanlight::mesh
