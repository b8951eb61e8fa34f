#pragma once

#include "raster/lanes/numbers.h"
#include "raster/visible_items.h"

namespace scanlight::raster::HWY_NAMESPACE {

/// The records of a vector's pixels, given their items; -1 where nothing is.
inline Ints admit_lanes(Ints items, VisibleItems& visible) {
    const Ints safe = max(items, Ints(0));
    const std::int32_t* record_of = visible.record_of().data();
    const Mask shown = Ints(-1) < items;
    Ints records = gather(record_of, safe);
    const Mask first_seen = shown & (records == Ints(VisibleItems::unseen));
    if (any(first_seen)) {
        std::int32_t item[lane_count];
        store(items, item);
        for (std::uint32_t left = bits_of(first_seen); left != 0; left &= left - 1)
            visible.admit(item[std::countr_zero(left)]);
        records = gather(record_of, safe);
    }
    return select(shown, records, Ints(no_item));
}

/// Puts in the place of each pixel's item what `VisibleItems::admit` says.
inline void collect_visible(VisibleBand& band, VisibleItems& visible) {
    for (int y = band.rows().y_begin; y < band.rows().y_end; ++y) {
        Item* const row = band.item_row(y);
        for (int x = 0; x < band.width(); x += lane_count) {
            const Ints items = load(row + x);
            if (any(Ints(-1) < items)) store(admit_lanes(items, visible), row + x);
        }
    }
}

}  // namespace scanlight::raster::HWY_NAMESPACE
