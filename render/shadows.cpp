#include "render/shadows.h"

#include <algorithm>
#include <optional>

#include "render/light_view.h"
#include "render/shadow_volume.h"

namespace scanlight::render {

namespace {

using Counts = raster::Plane<std::int32_t>;

using Face = ShadowCrossing;

bool reaches_beyond_far(const PlacedMesh& caster) {
    return std::ranges::any_of(caster.clip, [](const glm::vec4& position) {
        return raster::distance(position, raster::ClipPlane::far) < 0.0f;
    });
}

/// A light's shadow volumes on the screen.
class ScreenVolumes {
public:
    ScreenVolumes(const Scene& scene, const Settings& settings, std::size_t light,
                  raster::Viewport viewport)
        : scene_(scene),
          settings_(settings),
          frame_(frame_of(scene, settings.distances, viewport)),
          light_(homogeneous(frame_.lighting.lights[light])) {}

    /// Calls `visit(polygon, face)` for each part of each face that is on the screen.
    template <class Visit>
    void for_each_part(Visit&& visit) const {
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            const Object& object = scene_.objects[i];
            if (!casts_shadow(object, settings_of(object, settings_))) continue;
            std::optional<mesh::SilhouetteFinder> own;
            const mesh::SilhouetteFinder& silhouettes =
                object.silhouettes != nullptr ? *object.silhouettes : own.emplace(*object.mesh);
            const ShadowVolume volume(object, silhouettes, light_, frame_);
            const auto deep = deep_for(frame_, reaches_beyond_far(placed(object, frame_)));
            visit_caps(volume, i, deep, visit);
            visit_sides(volume, i, deep, visit);
        }
    }

private:
    template <class Visit>
    void visit_caps(const ShadowVolume& volume, std::size_t object, raster::Deep deep,
                    Visit& visit) const {
        volume.for_each_cap([&](const auto& corners, std::int32_t count, bool at_end,
                                std::size_t number) {
            const auto part = at_end ? VolumePart::end : VolumePart::cap;
            const Face face{object, part, scene_.objects[object].mesh->face_id[number], {}, count};
            visit_clipped(corners, at_end ? raster::Deep::beyond : deep, face, visit);
        });
    }

    template <class Visit>
    void visit_sides(const ShadowVolume& volume, std::size_t object, raster::Deep deep,
                     Visit& visit) const {
        volume.for_each_side([&](const auto& corners, std::int32_t count,
                                 const mesh::SilhouetteEdge& edge) {
            const Face face{object, VolumePart::side, 0, edge, count};
            const auto in_triangles = [&](const auto& polygon, const Face& of) {
                raster::for_each_triangle(polygon, [&](const auto& piece) { visit(piece, of); });
            };
            raster::for_each_triangle(corners, [&](const auto& triangle) {
                visit_clipped(triangle, deep, face, in_triangles);
            });
        });
    }

    template <class Visit>
    void visit_clipped(const raster::BareClipPolygon& corners, raster::Deep deep, Face face,
                       Visit&& visit) const {
        raster::clip_volume_face(corners, deep, frame_.viewport,
                                 [&](const auto& part) { visit(part, face); });
        if (settings_.shadows == Shadows::zpass_from_zero) return;
        // The count does not begin at 0 where the eye is in a volume.
        face.part = VolumePart::near_cut;
        raster::near_section(corners, frame_.viewport,
                             [&](const auto& part) { visit(part, face); });
    }

    const Scene& scene_;
    Settings settings_;
    Frame frame_;
    glm::dvec4 light_;
};

/// Counts the faces of shadow volumes before or behind what is seen, pixel by pixel: those through
/// which a ray from the eye enters, less those through which it leaves. z-fail (Bilodeau & Songy
/// 1999; Carmack 2000) counts from infinity back to the surface, and needs no section.
void tally(const raster::Span<0>& span, std::int32_t entered, Shadows method,
           const raster::Plane<raster::Depth>& depth, Counts& counts) {
    if (method == Shadows::zfail) {
        count_span(span, raster::StencilCount::where_not_nearer, -entered, depth, counts);
    } else {
        count_span(span, raster::StencilCount::where_nearer, entered, depth, counts);
    }
}

/// The triangles that close an object's volume at the near plane lie over one another; together
/// they say how many volumes the eye's ray begins in.
std::vector<ShadowCrossing> with_joint_cuts(const std::vector<ShadowCrossing>& crossings) {
    std::vector<ShadowCrossing> result;
    for (const ShadowCrossing& crossing : crossings) {
        const auto same = std::ranges::find_if(result, [&](const ShadowCrossing& other) {
            return crossing.part == VolumePart::near_cut && other.part == VolumePart::near_cut &&
                   other.object == crossing.object;
        });
        if (same == result.end()) {
            result.push_back(crossing);
        } else {
            same->entered += crossing.entered;
        }
    }
    std::erase_if(result, [](const ShadowCrossing& crossing) { return crossing.entered == 0; });
    return result;
}

}  // namespace

Counts count_shadows(const Scene& scene, const Settings& settings, std::size_t light,
                     const raster::Plane<raster::Depth>& depth) {
    const raster::Viewport viewport{depth.width(), depth.height()};
    Counts counts(viewport, 0);
    raster::PolygonFiller<0, raster::FillRule::winding> filler;
    const auto fill = [&](const raster::BareScreenPolygon& polygon, const Face& face) {
        filler.fill(std::span(polygon), raster::Interpolation::planar,
                    [&](const raster::Span<0>& span) {
                        tally(span, span.winding * face.entered, settings.shadows, depth, counts);
                    });
    };
    ScreenVolumes(scene, settings, light, viewport).for_each_part(fill);
    return counts;
}

std::vector<ShadowCrossing> shadow_crossings(const Scene& scene, const Settings& settings,
                                             std::size_t light, raster::Viewport viewport, int x,
                                             int y) {
    std::vector<ShadowCrossing> crossings;
    raster::PolygonFiller<0, raster::FillRule::winding> filler;
    const auto cross = [&](const raster::BareScreenPolygon& polygon, Face face) {
        const auto emit = [&](raster::Span<0> span) {
            if (x < span.x_begin || x >= span.x_end) return;
            span.ramps.step(x - span.x_begin);
            Face crossed = face;
            crossed.entered *= span.winding;
            crossed.depth = span.ramps.depth.get();
            crossings.push_back(crossed);
        };
        filler.fill(std::span(polygon), raster::Interpolation::planar, emit, raster::NoObserver{},
                    {y, y + 1});
    };
    ScreenVolumes(scene, settings, light, viewport).for_each_part(cross);
    std::ranges::stable_sort(crossings, {}, &ShadowCrossing::depth);
    return with_joint_cuts(crossings);
}

}  // namespace scanlight::render
