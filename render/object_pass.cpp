#include "render/object_pass.h"

#include <algorithm>
#include <cassert>

#include "render/gouraud.h"

namespace scanlight::render {

namespace {

raster::PolygonStreams polygons_of(const ObjectPass& pass) {
    const VertexStreams& v = pass.vertices;
    return {v.x,
            v.y,
            v.z,
            v.outside,
            pass.mesh().corners,
            pass.mesh().face_begin,
            pass.placing.mirrored,
            0};
}

/// Of each vertex; none where there is one material only.
std::vector<std::int32_t> materials_of_vertices(const Object& object) {
    if (object.materials.size() == 1) return {};
    const auto materials = vertex_materials(*object.mesh);
    std::vector<std::int32_t> result(materials.begin(), materials.end());
    result.resize(result.size() + raster::most_lanes);
    return result;
}

raster::AttributeStream colors(const std::vector<float>& front, const std::vector<float>& back,
                               float unit) {
    return {front.data(), back.empty() ? front.data() : back.data(), 1.0f / unit, 1.0f / unit};
}

raster::AttributeStream of_both_sides(const std::vector<float>& stream, float back_scale) {
    return {stream.data(), stream.data(), 1.0f, back_scale};
}

/// See `GouraudTechnique`.
void interpolate_intensities(const ObjectPass& pass, raster::Attributes& to) {
    to.streams[0] = colors(pass.front.x, pass.back.x, pass.unit);
    to.streams[1] = colors(pass.front.y, pass.back.y, pass.unit);
    to.streams[2] = colors(pass.front.z, pass.back.z, pass.unit);
    to.count = 4;  // the last is the constant 1
}

raster::AttributeStream scaled(const std::vector<float>& stream, float scale) {
    return {stream.data(), stream.data(), scale, scale};
}

/// See `PhongTechnique` and `TexturedPhongTechnique`.
void interpolate_normals(const ObjectPass& pass, raster::Attributes& to) {
    const VectorStreams& normals = pass.vertices.normals;
    const mesh::Vertices& vertices = pass.mesh().vertices;
    int count = 0;
    const auto add = [&](const raster::AttributeStream& stream) {
        to.streams[static_cast<std::size_t>(count++)] = stream;
    };
    for (const auto* part : {&normals.x, &normals.y, &normals.z})
        add(of_both_sides(*part, -1.0f));
    if (pass.textured.has_colors) {
        for (const auto* channel : {&vertices.red, &vertices.green, &vertices.blue})
            add(scaled(*channel, 1.0f));
    }
    if (pass.textured.has_uvs) {
        add(scaled(vertices.u, 1.0f / pass.uv_unit));
        add(scaled(vertices.v, 1.0f / pass.uv_unit));
    }
    to.count =
        pass.textured.count();  // the last, if there is more than the normal, is the constant 1
}

/// Most faces then have several pixels, unless they are hidden.
bool has_large_faces(const ObjectPass& pass) {
    const raster::Viewport& size = pass.frame->viewport;
    const auto pixels =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return pass.mesh().face_count() <= pixels / 8;
}

}  // namespace

std::size_t ObjectPass::bytes() const {
    std::size_t sum = vertices.bytes() + front.bytes() + back.bytes();
    sum += raster::bytes_held(vertex_material, face_uvs, is_magnified, bins);
    for (const raster::Bin& bin : bins)
        sum += bin.bytes();
    for (const ShadowSides& shadow : sides)
        sum += shadow.bytes();
    return sum;
}

void ObjectPass::begin(const Object& begun, std::size_t first_face, const Frame& its_frame,
                       const Settings& picture) {
    assert(begun.materials.size() == begun.mesh->materials.size());
    assert(first_face + begun.mesh->face_count() <= raster::most_faces);
    object = &begun;
    faces = {static_cast<std::int32_t>(first_face),
             static_cast<std::int32_t>(begun.mesh->face_count())};
    frame = &its_frame;
    settings = settings_of(begun, picture);
    placing = placing_of(object->world_from_object, *frame);
    vertices.resize(mesh().vertices.size(), settings.shading != Shading::phong,
                    settings.shading != Shading::flat);
    polygons = polygons_of(*this);
    begin_textures();
    needs_point = needs.point || has_lamp(frame->lighting);
}

void ObjectPass::begin_textures() {
    textured = {mesh().vertices.has_colors(), false};
    textures.clear();
    face_uvs.clear();
    is_magnified.clear();
    needs = {};
    if (settings.shading != Shading::phong || !is_textured(*object, *frame)) return;
    textured = textured_attributes(*object);
    textures = placed_textures(*object);
    face_matrices = render::face_matrices(*object, *frame);
    needs = site_needs(*object);
    const bool asks_faces = textured.has_uvs && (needs.uv_steps || needs.gradients);
    if (asks_faces && has_large_faces(*this)) {
        face_uvs.resize(mesh().face_count());
        is_magnified.resize(needs.uv_steps ? mesh().face_count() : 0);
    }
    uv_unit = textured.has_uvs ? uv_unit_of(mesh().vertices) : 1.0f;
}

void ObjectPass::begin_shadows(std::size_t lights) {
    sides.resize(lights);
    if (lights > 0 && object->silhouettes == nullptr) own_silhouettes.emplace(mesh());
}

void ObjectPass::begin_vertex_light() {
    vertex_material = materials_of_vertices(*object);
    front.resize(vertices.w.size());
    back.resize(settings.sides == Sides::two ? vertices.w.size() : 0);
}

void ObjectPass::end_vertices() {
    attributes = {};
    attributes.w = vertices.w;
    attributes.perspective_correct = settings.perspective == Perspective::correct;
    if (settings.shading == Shading::gouraud) interpolate_intensities(*this, attributes);
    if (settings.shading == Shading::phong) interpolate_normals(*this, attributes);
}

void store_colors(std::span<const raster::Rgba> colors, int y, const Target& target) {
    if (const auto* floats = std::get_if<FloatTarget>(&target)) {
        std::ranges::copy(colors, floats->row(y).begin());
    } else {
        const auto& packed = std::get<PackedTarget>(target);
        std::ranges::transform(colors, packed.row(y).begin(), [&](const raster::Rgba& color) {
            return raster::packed_pixel(color, packed.encoding);
        });
    }
}

std::optional<raster::Encoding> light_at_once(std::span<const ObjectPass> passes,
                                              const Target& target) {
    const bool waits = std::ranges::any_of(passes, [](const ObjectPass& pass) {
        return pass.settings.shading == Shading::phong || pass.settings.shadows != Shadows::none ||
               pass.settings.grid > 1;
    });
    const auto* packed = std::get_if<PackedTarget>(&target);
    return packed != nullptr && !waits ? std::optional(packed->encoding) : std::nullopt;
}

}  // namespace scanlight::render
