#include "render/shadows.h"

#include <algorithm>
#include <utility>

#include "render/shadow_volume.h"

namespace scanlight::render {

namespace {

using Counts = raster::Plane<std::int32_t>;

/// Counts the faces of shadow volumes before or behind what is seen, pixel by pixel: those through
/// which a ray from the eye enters, less those through which it leaves.
class ShadowCounter {
public:
    ShadowCounter(Shadows method, raster::Viewport viewport,
                  const raster::Plane<raster::Depth>& depth, Counts& counts)
        : method_(method), viewport_(viewport), depth_(depth), counts_(counts) {}

    void add(const ShadowVolume& volume, raster::Deep deep) {
        volume.for_each_cap([&](const auto& face, std::int32_t count, bool at_end) {
            add(face, at_end ? raster::Deep::beyond : deep,
                [&](const auto& part) { fill(part, count); });
        });
        volume.for_each_side([&](const auto& face, std::int32_t count) {
            raster::for_each_triangle(face, [&](const auto& triangle) {
                add(triangle, deep, [&](const auto& part) {
                    raster::for_each_triangle(part, [&](const auto& piece) { fill(piece, count); });
                });
            });
        });
    }

private:
    template <class Fill>
    void add(const raster::BareClipPolygon& face, raster::Deep deep, Fill&& fill) {
        raster::clip_volume_face(face, deep, viewport_, fill);
        // The count does not begin at 0 where the eye is in a volume.
        if (method_ == Shadows::zpass) raster::near_section(face, viewport_, fill);
    }

    void fill(const raster::BareScreenPolygon& polygon, std::int32_t count) {
        filler_.fill(std::span(polygon), raster::Interpolation::planar,
                     [&](const raster::Span<0>& span) { tally(span, span.winding * count); });
    }

    /// z-fail (Bilodeau & Songy 1999; Carmack 2000) counts from infinity back to the surface.
    void tally(const raster::Span<0>& span, std::int32_t entered) {
        if (method_ == Shadows::zfail) {
            count_span(span, raster::StencilCount::where_not_nearer, -entered, depth_, counts_);
        } else {
            count_span(span, raster::StencilCount::where_nearer, entered, depth_, counts_);
        }
    }

    Shadows method_;
    raster::Viewport viewport_;
    const raster::Plane<raster::Depth>& depth_;
    Counts& counts_;
    raster::PolygonFiller<0, raster::FillRule::winding> filler_;
};

bool reaches_beyond_far(const PlacedMesh& caster) {
    return std::ranges::any_of(caster.clip, [](const glm::vec4& position) {
        return raster::distance(position, raster::ClipPlane::far) < 0.0f;
    });
}

/// The same scene in other light.
Scene lit_by(Scene scene, shading::Lighting<float> lighting) {
    scene.lighting = std::move(lighting);
    return scene;
}

void add_light(const Drawing& lit, const Counts& counts, Drawing& sum) {
    const raster::Viewport size = sum.framebuffer.size();
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool is_drawn = lit.framebuffer.depth.at(x, y) < raster::depth_clear;
            if (!is_drawn || counts.at(x, y) != 0) continue;
            sum.framebuffer.color.at(x, y) +=
                raster::Rgba(glm::vec3(lit.framebuffer.color.at(x, y)), 0.0f);
        }
    }
}

}  // namespace

Counts count_shadows(const Scene& scene, const Settings& settings, std::size_t light,
                     const raster::Plane<raster::Depth>& depth) {
    const raster::Viewport viewport{depth.width(), depth.height()};
    const Frame frame = frame_of(scene, settings.distances, viewport);
    Counts counts(viewport, 0);
    ShadowCounter counter(settings.shadows, viewport, depth, counts);
    for (const Object& object : scene.objects) {
        const ShadowVolume volume(object, mesh::SilhouetteFinder(*object.mesh),
                                  homogeneous(frame.lighting.lights[light]), frame);
        counter.add(volume, deep_for(frame, reaches_beyond_far(placed(object, frame))));
    }
    return counts;
}

Drawing draw_with_shadows(const Scene& scene, const Settings& settings, raster::Viewport viewport) {
    Settings unshadowed = settings;
    unshadowed.shadows = Shadows::none;
    Drawing sum = draw(lit_by(scene, {scene.lighting.ambient, {}}), unshadowed, viewport);
    for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
        const Counts counts = count_shadows(scene, settings, i, sum.framebuffer.depth);
        const shading::Lighting<float> alone{glm::vec3(0.0f), {scene.lighting.lights[i]}};
        add_light(draw(lit_by(scene, alone), unshadowed, viewport), counts, sum);
    }
    return sum;
}

}  // namespace scanlight::render
