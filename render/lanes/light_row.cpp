#include "render/lanes/light_row.h"

#include "render/lanes/shade.h"
#include "shading/few.h"

namespace scanlight::render::HWY_NAMESPACE {

namespace {

/// Lights the pixels of an object in one row by what they keep.
template <class Technique>
class RowLighter {
public:
    RowLighter(const Technique& technique, const ObjectPass& pass, raster::VisibleBand& band,
               const ShadowBand* shadows, int y)
        : technique_(technique),
          faces_(pass.faces),
          has_one_material_(pass.object->materials.size() == 1),
          band_(band),
          shadows_(shadows),
          y_(y),
          sight_(pass.frame->sight_row(y)) {}

    /// First what surfaces a few vectors of pixels show, then their light.
    SCANLIGHT_FLATTEN std::size_t light(RowWriter& to) const {
        const raster::Columns columns = band_.touched();
        std::size_t pixels = 0;
        for (int x = columns.begin; x < columns.end;) {
            shading::Few<Seen> seen;
            for (; x < columns.end && !seen.is_full(); x += lane_count)
                see(x, seen, to);
            light(seen, [&](int i, const ColorLanes& color) {
                const Mask shown = seen[i].faces.shown;
                to.write(seen[i].x, shown, color.x, color.y, color.z);
                pixels += static_cast<std::size_t>(count(shown));
            });
        }
        return pixels;
    }

    SCANLIGHT_FLATTEN void find_opacity(std::vector<float>& row) const {
        const raster::Columns columns = band_.touched();
        PixelLanes pixels;
        for (int x = columns.begin; x < columns.end; x += lane_count) {
            if (read(x, pixels)) store(technique_.opacity(pixels), row.data() + x);
        }
    }

private:
    struct Seen {
        int x;
        FaceLanes faces;
        typename Technique::Surface surface;
    };

    /// Some techniques light a few vectors of pixels together, if all are of one material.
    template <class Write>
    void light(const shading::Few<Seen>& seen, Write&& write) const {
        if (seen.count() == 0) return;
        if constexpr (requires { technique_.light_few(seen, write); }) {
            if (has_one_material_) return technique_.light_few(seen, write);
        }
        for (int i = 0; i < seen.count(); ++i)
            write(i, technique_.light(seen[i].faces, seen[i].surface));
    }

    void see(int x, shading::Few<Seen>& seen, RowWriter& to) const {
        PixelLanes pixels;
        if (!read(x, pixels)) return to.leave_out(x);
        seen.add([&] { return Seen{x, pixels, technique_.surface(pixels)}; });
    }

    /// False where nothing is shown.
    bool read(int x, PixelLanes& pixels) const {
        const raster::PixelPlace at = band_.row(y_) + x;
        const Ints kept = load(at.kept(0));
        const Ints item = kept - Ints(faces_.first);
        pixels.shown = lanes_held(faces_, kept);
        if (!any(pixels.shown)) return false;
        pixels.x = x;
        pixels.y = y_;
        pixels.place = at;
        pixels.sight = &sight_;
        pixels.shadowed = shadows_ == nullptr ? Ints(0) : load(shadows_->row(y_) + x);
        pixels.item = all(pixels.shown) ? item : with_neighbours(item, pixels.shown);
        return true;
    }

    static Ints with_neighbours(Ints item, Mask shown) {
        std::int32_t items[lane_count];
        store(item, items);
        return select(shown, item, Ints(items[std::countr_zero(bits_of(shown))]));
    }

    const Technique& technique_;
    FaceRange faces_;
    bool has_one_material_;
    raster::VisibleBand& band_;
    const ShadowBand* shadows_;
    int y_;
    SightRow sight_;
};

}  // namespace

std::size_t light_row(const ObjectPass& pass, raster::VisibleBand& band, const ShadowBand* shadows,
                      int y, RowWriter& to) {
    return with_technique(pass, [&](const auto& technique) {
        return RowLighter(technique, pass, band, shadows, y).light(to);
    });
}

void find_row_opacity(const ObjectPass& pass, raster::VisibleBand& band, int y,
                      std::vector<float>& row) {
    with_technique(pass, [&](const auto& technique) {
        RowLighter(technique, pass, band, nullptr, y).find_opacity(row);
    });
}

}  // namespace scanlight::render::HWY_NAMESPACE
