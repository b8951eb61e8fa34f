#include "raster/attribute_records.h"

namespace scanlight::raster {

void set_record(RecordStreams& streams, std::size_t record, const Ramp& ramp, int x_begin) {
    const std::uint64_t step = static_cast<std::uint64_t>(ramp.step_size);
    const std::uint64_t origin = static_cast<std::uint64_t>(ramp.value) -
                                 static_cast<std::uint64_t>(x_begin) * step +
                                 static_cast<std::uint64_t>(Ramp::half);
    streams.whole[record] = static_cast<std::int32_t>(origin >> ramp_bits);
    streams.dx[record] = static_cast<std::int32_t>(step >> ramp_bits);
    streams.dy[record] = 0;
    streams.fraction[record] = static_cast<std::int32_t>(origin & 0xffff);
    streams.fraction_dx[record] = static_cast<std::int32_t>(step & 0xffff);
}

}  // namespace scanlight::raster
