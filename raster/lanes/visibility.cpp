#include "raster/lane_path.h"
#include "raster/lanes/band_painter.h"
#include "raster/lanes/cull.h"

namespace scanlight::raster::HWY_NAMESPACE {

namespace {

void cull_faces(const PolygonStreams& streams, CullRule rule, std::size_t begin, std::size_t end,
                Survivors& survivors, FateCounts& counts) {
    FaceCuller(streams, rule).cull(begin, end, survivors, counts);
}

void draw_items(const PolygonStreams& streams, std::span<const FaceItem> items, std::int32_t first,
                VisibleBand& band, Walker& walker) {
    BandPainter<KeepItem>(streams, {}, KeepItem(first), band, walker).draw(items);
}

}  // namespace

extern const LanePath lane_path;
const LanePath lane_path{hwy::TargetName(HWY_TARGET), lane_count, cull_faces, draw_items};

}  // namespace scanlight::raster::HWY_NAMESPACE
