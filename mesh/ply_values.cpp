#include "mesh/ply_values.h"

#include <cmath>
#include <limits>

#include "mesh/file_error.h"

namespace scanlight::mesh {
namespace {

struct Range {
    double least;
    double most;
};

template <class Integer>
constexpr Range range_of() {
    return {std::numeric_limits<Integer>::min(), std::numeric_limits<Integer>::max()};
}

Range range_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
            return range_of<std::int8_t>();
        case PlyType::uint8:
            return range_of<std::uint8_t>();
        case PlyType::int16:
            return range_of<std::int16_t>();
        case PlyType::uint16:
            return range_of<std::uint16_t>();
        case PlyType::int32:
            return range_of<std::int32_t>();
        case PlyType::uint32:
            return range_of<std::uint32_t>();
        case PlyType::float32:
        case PlyType::float64:
            break;
    }
    return {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
}

std::string too_long(std::uint64_t count, std::size_t bytes_left) {
    return "a list of " + std::to_string(count) + " values is declared, but only " +
           counted(bytes_left, "byte is", "bytes are") + " left";
}

}  // namespace

PlyTextValues::PlyTextValues(std::string_view bytes, const std::string& name,
                             std::size_t header_size)
    : text_(bytes, name) {
    text_.seek(header_size);
}

double PlyTextValues::value(PlyType type) {
    text_.at_line_end();  // to the number's first byte
    const std::size_t start = text_.offset();
    const double value = text_.number();
    const Range range = range_of(type);
    const bool fits = range.least <= value && value <= range.most;
    if (fits && (!is_integer(type) || value == std::trunc(value))) return value;
    text_.fail(quoted(text_.since(start)) + " does not fit the type of its property");
}

void PlyTextValues::skip(PlyType, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
        if (text_.word().empty()) text_.fail("a number is missing");
    }
}

void PlyTextValues::end_record() {
    if (!text_.at_line_end()) text_.fail("more numbers on the line than the header declares");
    text_.next_line();
}

void PlyTextValues::expect_room(PlyType, std::uint64_t count) const {
    if (count > room_for(2)) text_.fail(too_long(count, bytes_left()));
}

std::size_t PlyTextValues::unread() {
    text_.skip_space();
    return text_.bytes_left();
}

template <std::endian order>
void PlyBinaryValues<order>::skip(PlyType type, std::uint64_t count) {
    expect_room(type, count);
    here_ += size_of(type) * count;
}

template <std::endian order>
void PlyBinaryValues<order>::fail_at_length(std::uint64_t count) const {
    fail(too_long(count, bytes_left()));
}

template <std::endian order>
void PlyBinaryValues<order>::fail(const std::string& reason) const {
    throw FileError(name_ + ": byte " + std::to_string(here_ - begin_) + ": " + reason);
}

template class PlyBinaryValues<std::endian::little>;
template class PlyBinaryValues<std::endian::big>;

}  // namespace scanlight::mesh
