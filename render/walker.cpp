#include "render/walker.h"

#include <array>
#include <cassert>

#include "raster/clip.h"
#include "raster/project.h"
#include "render/transform.h"

namespace scanlight::render {

namespace {

template <int N>
std::array<raster::AttributeSide, N> sides_seen(const raster::Attributes& attributes,
                                                raster::FaceItem item) {
    std::array<raster::AttributeSide, N> sides;
    for (std::size_t k = 0; k < N; ++k)
        sides[k] = {attributes.streams[k], item};
    return sides;
}

template <int N>
std::vector<raster::ClipVertex<N>> gathered(const ObjectPass& pass, raster::FaceItem item) {
    const auto sides = sides_seen<N>(pass.attributes, item);
    std::vector<raster::ClipVertex<N>> polygon;
    for (const std::uint32_t vertex : pass.mesh().face(item & raster::face_mask)) {
        auto& corner = polygon.emplace_back();
        corner.position = clip_position(pass, vertex);
        for (std::size_t k = 0; k < N; ++k)
            corner.attributes[k] = sides[k][vertex];
    }
    return polygon;
}

template <int N>
std::vector<raster::ScreenVertex<N>> clipped(const ObjectPass& pass, raster::FaceItem item) {
    const auto polygon = raster::clip(gathered<N>(pass, item));
    return pass.attributes.perspective_correct
               ? raster::project_correct(polygon, pass.frame->viewport)
               : raster::project_affine(polygon, pass.frame->viewport);
}

bool is_inside(const ObjectPass& pass, std::span<const std::uint32_t> vertices) {
    std::int32_t outside = 0;
    for (const std::uint32_t v : vertices)
        outside |= pass.polygons.outside[v];
    return outside == 0;
}

/// Corners that the vertex stage has put on the screen, with their attributes as `project_correct`
/// and `project_affine` scale them.
template <int N>
void gather_on_screen(const ObjectPass& pass, raster::FaceItem item,
                      std::span<const std::uint32_t> vertices,
                      std::vector<raster::ScreenVertex<N>>& corners) {
    const auto& attributes = pass.attributes;
    const auto sides = sides_seen<N>(attributes, item);
    float w_min = attributes.w[vertices.front()];
    for (const std::uint32_t v : vertices)
        w_min = std::min(w_min, attributes.w[v]);
    corners.clear();
    for (const std::uint32_t v : vertices) {
        auto& corner = corners.emplace_back();  // filled in its place: a copy would wait for it
        corner.x = pass.polygons.x[v];
        corner.y = pass.polygons.y[v];
        corner.z = pass.polygons.z[v];
        const float scale = attributes.perspective_correct ? w_min / attributes.w[v] : 1.0f;
        for (std::size_t k = 0; k < N; ++k)
            corner.attributes[k] = raster::attribute_from_float(sides[k][v] * scale);
    }
}

/// The same, of corners whose attributes are known.
template <int N>
void gather_on_screen(const ObjectPass& pass, std::span<const std::uint32_t> vertices,
                      const raster::CornerAttributes& known,
                      std::vector<raster::ScreenVertex<N>>& corners) {
    corners.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        auto& corner = corners[i];
        corner.x = pass.polygons.x[vertices[i]];
        corner.y = pass.polygons.y[vertices[i]];
        corner.z = pass.polygons.z[vertices[i]];
        for (std::size_t k = 0; k < N; ++k)
            corner.attributes[k] = known.at(i, k);
    }
}

template <int N>
void gather_corners(const ObjectPass& pass, raster::FaceItem item,
                    const raster::CornerAttributes* known,
                    std::vector<raster::ScreenVertex<N>>& corners) {
    const auto vertices = pass.mesh().face(item & raster::face_mask);
    if (!is_inside(pass, vertices)) {
        corners = clipped<N>(pass, item);
    } else if (known != nullptr && vertices.size() <= raster::CornerAttributes::most_corners) {
        gather_on_screen(pass, vertices, *known, corners);
    } else {
        gather_on_screen(pass, item, vertices, corners);
    }
}

}  // namespace

glm::vec4 clip_position(const ObjectPass& pass, std::uint32_t vertex) {
    const glm::dvec3 position(pass.mesh().vertices.position(vertex));
    return glm::vec4(transformed_point(pass.placing.clip_from_object, position));
}

std::vector<raster::ScreenVertex<0>> clipped_face(const ObjectPass& pass, std::size_t face) {
    return clipped<0>(pass, static_cast<raster::FaceItem>(face));
}

void Walker::draw(raster::FaceItem face, const raster::CornerAttributes* known,
                  raster::SpanPainter& spans) {
    switch (pass_.attributes.count) {
        case 0:
            return walk<0>(face, known, spans);
        case 3:
            return walk<3>(face, known, spans);
        case 4:
            return walk<4>(face, known, spans);
        case 6:
            return walk<6>(face, known, spans);
        case 7:
            return walk<7>(face, known, spans);
        case 9:
            return walk<9>(face, known, spans);
        default:
            assert(false && "no technique has so many attributes");
    }
}

template <int N>
void Walker::walk(raster::FaceItem face, const raster::CornerAttributes* known,
                  raster::SpanPainter& spans) {
    auto& [filler, corners] = std::get<WalkMemory<N>>(memories_);
    gather_corners(pass_, face, known, corners);
    const auto emit = [&](const raster::Span<N>& span) {
        spans.draw_span(span.y, span.x_begin, span.x_end, span.ramps.depth,
                        span.ramps.attributes.data());
    };
    filler.fill(corners, raster::Interpolation::planar, emit, raster::NoObserver{}, rows_);
}

}  // namespace scanlight::render
