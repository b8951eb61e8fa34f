#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "raster/attribute_records.h"
#include "raster/bins.h"
#include "raster/fill.h"
#include "raster/visible_band.h"

namespace scanlight::raster {

/// The items that a band shows, in the order of their first pixels, row by row from left to right:
/// the records of their attributes bear their faces.
class VisibleItems {
public:
    /// Where walked polygons, whose values differ from span to span, get no record at first.
    enum class Walked { like_others, apart };

    void clear(std::span<const FaceItem> items, int attribute_count, Walked walked) {
        items_ = items;
        walked_apart_ = walked == Walked::apart;
        record_of_.assign(items.size(), unseen);
        walked_.clear();
        records.clear(attribute_count);
    }

    /// What to write in the place of an item's number: its record, or a tag below -1.
    std::int32_t admit(Item item) {
        std::int32_t& record = record_of_[static_cast<std::size_t>(item)];
        if (record != unseen) return record;
        const FaceItem face = items_[static_cast<std::size_t>(item)];
        if (walked_apart_ && (face & walk_flag) != 0) {
            walked_.push_back(face);
            return record = -1 - static_cast<std::int32_t>(walked_.size());
        }
        return record = add(face);
    }

    /// A new record of a face; its numbers are to be written.
    std::int32_t add(FaceItem face) {
        records.reserve(records.count + 1);
        records.face[records.count] = static_cast<std::int32_t>(face);
        return static_cast<std::int32_t>(records.count++);
    }

    /// The tag in the pixels of the i-th walked polygon.
    static std::int32_t tag(std::size_t i) { return -2 - static_cast<std::int32_t>(i); }
    std::span<const FaceItem> walked() const { return walked_; }

    /// A record or tag for each item, or `unseen`.
    const std::vector<std::int32_t>& record_of() const { return record_of_; }
    static constexpr std::int32_t unseen = -1;

    AttributeRecords records;

private:
    std::span<const FaceItem> items_;
    bool walked_apart_ = true;
    std::vector<std::int32_t> record_of_;
    std::vector<FaceItem> walked_;
};

/// Gives each span of a walked polygon, in the rows of the band, a record of its own, and its
/// pixels that bear `tag` the record's number. N attributes.
template <int N>
void record_spans(std::span<const ScreenVertex<N>> corners, FaceItem face, std::int32_t tag,
                  PolygonFiller<N>& filler, VisibleBand& band, VisibleItems& visible) {
    const auto record = [&](const Span<N>& span) {
        const std::int32_t number = visible.add(face);
        for (std::size_t k = 0; k < N; ++k) {
            set_record(visible.records.attributes[k], static_cast<std::size_t>(number),
                       span.ramps.attributes[k], span.x_begin);
        }
        Item* const row = band.item_row(span.y);
        for (int x = span.x_begin; x < span.x_end; ++x)
            row[x] = row[x] == tag ? number : row[x];
    };
    visible.records.has_fractions = true;
    filler.fill(corners, Interpolation::planar, record, NoObserver{}, band.rows());
}

}  // namespace scanlight::raster
