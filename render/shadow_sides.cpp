#include "render/shadow_sides.h"

#include <algorithm>

#include "render/object_pass.h"
#include "render/shadow_volume.h"

namespace scanlight::render {

namespace {

bool has_vertex_outside(const ObjectPass& pass, raster::ClipPlane plane) {
    return (pass.polygons.outside_of_any & raster::outside_bit(plane)) != 0;
}

bool has_large_polygon(const mesh::Mesh& mesh) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face(f).size() > 4) return true;
    }
    return false;
}

}  // namespace

void ShadowSides::find(const ObjectPass& pass, const glm::dvec4& light,
                       const raster::Bands& bands) {
    triangles_.clear();
    if (casts_shadow(*pass.object, pass.settings)) find_triangles(pass, light);
    sort_into(bands);
}

void ShadowSides::find_triangles(const ObjectPass& pass, const glm::dvec4& light) {
    const raster::Viewport viewport = pass.frame->viewport;
    const ShadowVolume volume(*pass.object, pass.silhouettes(), light, *pass.frame);
    const auto deep = deep_for(*pass.frame, has_vertex_outside(pass, raster::ClipPlane::far));
    const bool has_section = pass.settings.shadows != Shadows::zpass_from_zero;
    const auto add = [&](const raster::BareScreenPolygon& polygon, std::int32_t count) {
        raster::for_each_triangle(polygon, [&](const raster::BareScreenPolygon& t) {
            triangles_.push_back({{t[0], t[1], t[2]}, count});
        });
    };
    volume.for_each_side([&](const auto& side, std::int32_t count, const auto&) {
        raster::for_each_triangle(side, [&](const auto& triangle) {
            const auto visit = [&](const auto& part) { add(part, count); };
            raster::clip_volume_face(triangle, deep, viewport, visit);
            if (has_section) raster::near_section(triangle, viewport, visit);
        });
    });
    if (has_section && volume.has_cap_through_near()) {
        volume.for_each_cap([&](const auto& face, std::int32_t count, bool, std::size_t) {
            raster::near_section(face, viewport, [&](const auto& part) { add(part, count); });
        });
    }
}

void ShadowSides::sort_into(const raster::Bands& bands) {
    bands_.resize(static_cast<std::size_t>(bands.count()));
    for (auto& band : bands_)
        band.clear();
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
        const auto& [a, b, c] = triangles_[i].corners;
        const int begin = raster::first_centre(std::min({a.y, b.y, c.y}));
        const int end = raster::first_centre(std::max({a.y, b.y, c.y}));
        if (begin >= end) continue;
        for (int band = bands.holding(begin); band <= bands.holding(end - 1); ++band)
            bands_[static_cast<std::size_t>(band)].push_back(i);
    }
}

std::size_t ShadowSides::bytes() const {
    std::size_t sum = raster::bytes_held(triangles_, bands_);
    for (const auto& band : bands_)
        sum += raster::bytes_held(band);
    return sum;
}

bool sides_suffice(const Scene& scene, const Settings& settings) {
    return std::ranges::all_of(scene.objects, [&](const Object& object) {
        return settings_of(object, settings).cull == Cull::none && !has_large_polygon(*object.mesh);
    });
}

}  // namespace scanlight::render
