#include "raster/attribute_records.h"

namespace scanlight::raster {

void AttributeRecords::clear(int attributes_each) {
    count = 0;
    has_fractions = false;
    attribute_count = attributes_each;
    grow(face.size());
}

void AttributeRecords::grow(std::size_t n) {
    face.resize(n);
    for (int k = 0; k < attribute_count; ++k)
        attributes[static_cast<std::size_t>(k)].resize(n);
}

std::size_t AttributeRecords::bytes() const {
    std::size_t sum = bytes_held(face);
    for (const AttributeColumn& column : attributes)
        sum += column.bytes();
    return sum;
}

AttributeRecord record_of(const Ramp& ramp, int x_begin) {
    const auto step = static_cast<std::uint64_t>(ramp.step_size);
    const std::uint64_t origin = static_cast<std::uint64_t>(ramp.value) -
                                 static_cast<std::uint64_t>(x_begin) * step +
                                 static_cast<std::uint64_t>(Ramp::half);
    return {static_cast<std::int32_t>(origin >> ramp_bits),
            static_cast<std::int32_t>(step >> ramp_bits), 0,
            static_cast<std::int32_t>(origin & 0xffff), static_cast<std::int32_t>(step & 0xffff)};
}

}  // namespace scanlight::raster
