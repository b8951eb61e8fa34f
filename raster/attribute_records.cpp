#include "raster/attribute_records.h"

namespace scanlight::raster {

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
