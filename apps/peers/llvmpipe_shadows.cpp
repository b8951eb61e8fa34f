#include "apps/peers/llvmpipe_shadows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "apps/peers/gl_geometry.h"
#include "apps/peers/gl_program.h"
#include "render/frame.h"
#include "render/light_view.h"

namespace scanlight::peers {

namespace {

const GlSources ambient_sources{R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * vec4(position, 1.0); }
)",
                                R"(#version 330 core
uniform vec3 ambient;
out vec4 pixel;
void main() { pixel = vec4(ambient, 1.0); }
)"};

const GlSources volume_sources{R"(#version 330 core
layout(location = 0) in vec4 position;
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * position; }
)",
                               R"(#version 330 core
void main() {}
)"};

template <class T>
void fill_buffer(GLenum kind, GLuint buffer, const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

void set_attribute(GLuint number, int size, std::size_t floats_a_row, std::size_t begin) {
    glEnableVertexAttribArray(number);
    glVertexAttribPointer(number, size, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(floats_a_row * sizeof(float)),
                          reinterpret_cast<const void*>(begin * sizeof(float)));
}

/// Both meshes in one.
GlGeometry geometry_of(const ShadowStage& stage) {
    GlGeometry all = smooth_geometry(stage.caster());
    const GlGeometry floor = smooth_geometry(stage.floor());
    const auto first = static_cast<std::uint32_t>(stage.caster().vertices.size());
    all.numbers.insert(all.numbers.end(), floor.numbers.begin(), floor.numbers.end());
    for (const std::uint32_t corner : floor.corners)
        all.corners.push_back(first + corner);
    return all;
}

/// The mesh is closed where every edge that bounds its faces, all turned to the light, does so
/// twice: for those that see the light, and for those that do not. The first then suffice.
bool is_closed(const mesh::Silhouette& silhouette) {
    return std::ranges::all_of(silhouette.edges,
                               [](const auto& edge) { return edge.multiplicity % 2 == 0; });
}

/// In the order of `smooth_geometry`, lest depths differ in their last bits; turned to the light.
void append_cap(std::span<const std::uint32_t> face, mesh::Facing facing, GlGeometry& volume) {
    const bool front = facing == mesh::Facing::front;
    volume.corners.insert(volume.corners.end(),
                          {front ? face[1] : face[2], front ? face[2] : face[1], face[0]});
}

/// Homogeneous positions, the last the point at infinity away from the light; faces, and a triangle
/// for each edge that bounds them.
GlGeometry volume_of(const ShadowStage& stage) {
    const glm::dvec4 light = render::homogeneous(stage.scene().lighting.lights.front());
    const mesh::Silhouette silhouette = stage.silhouettes().from(light);
    const bool closed = is_closed(silhouette);
    const mesh::Vertices& vertices = stage.caster().vertices;
    GlGeometry volume{0, {}, {}};
    for (std::size_t i = 0; i < vertices.size(); ++i)
        volume.numbers.insert(volume.numbers.end(),
                              {vertices.x[i], vertices.y[i], vertices.z[i], 1});
    const glm::vec4 away(-light);
    volume.numbers.insert(volume.numbers.end(), {away.x, away.y, away.z, 0});
    const auto end = static_cast<std::uint32_t>(vertices.size());
    for (std::size_t f = 0; f < stage.caster().face_count(); ++f) {
        const mesh::Facing facing = silhouette.facing[f];
        const bool is_cap =
            facing == mesh::Facing::front || (facing == mesh::Facing::back && !closed);
        if (is_cap) append_cap(stage.caster().face(f), facing, volume);
    }
    for (const mesh::SilhouetteEdge& edge : silhouette.edges) {
        const bool forward = edge.multiplicity > 0;
        const int times = std::abs(edge.multiplicity) / (closed ? 2 : 1);
        for (int i = 0; i < times; ++i)
            volume.corners.insert(volume.corners.end(), {forward ? edge.to : edge.from,
                                                         forward ? edge.from : edge.to, end});
    }
    return volume;
}

}  // namespace

LlvmpipeShadows::LlvmpipeShadows(const GlTarget& target, const ShadowStage& stage,
                                 const render::Settings& settings)
    : target_(target) {
    const auto frame = render::frame_of(stage.scene(), settings.distances, stage.size());
    const auto& material = stage.scene().objects.front().materials.front();
    lit_.program = gl_program(settings, Coat::none, material, frame);
    ambient_.program = gl_program(ambient_sources, material, frame);
    volume_.program = gl_program(volume_sources, material, frame);
    const auto upload = [](Batch& batch, const GlGeometry& geometry) {
        batch.corners = static_cast<GLsizei>(geometry.corners.size());
        glGenVertexArrays(1, &batch.vertex_array);
        glBindVertexArray(batch.vertex_array);
        glGenBuffers(2, batch.buffers);
        fill_buffer(GL_ARRAY_BUFFER, batch.buffers[0], geometry.numbers);
        fill_buffer(GL_ELEMENT_ARRAY_BUFFER, batch.buffers[1], geometry.corners);
    };
    const GlGeometry geometry = geometry_of(stage);
    for (Batch* batch : {&lit_, &ambient_}) {
        upload(*batch, geometry);
        set_attribute(0, 3, 6, 0);
        set_attribute(1, 3, 6, 3);
    }
    upload(volume_, volume_of(stage));
    set_attribute(0, 4, 4, 0);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    glFrontFace(GL_CW);  // y is turned round
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    check_gl("uploading the shadows");
}

LlvmpipeShadows::~LlvmpipeShadows() {
    for (Batch* batch : {&lit_, &ambient_, &volume_})
        release(*batch);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_CLAMP);
}

void LlvmpipeShadows::release(Batch& batch) {
    glDeleteBuffers(2, batch.buffers);
    glDeleteVertexArrays(1, &batch.vertex_array);
    glDeleteProgram(batch.program);
}

void LlvmpipeShadows::draw(const Batch& batch) const {
    glUseProgram(batch.program);
    glBindVertexArray(batch.vertex_array);
    glDrawElements(GL_TRIANGLES, batch.corners, GL_UNSIGNED_INT, nullptr);
}

void LlvmpipeShadows::draw_unshadowed() {
    glDisable(GL_STENCIL_TEST);
    glDepthFunc(GL_LESS);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw(lit_);
    glFinish();
}

void LlvmpipeShadows::draw() {
    glDisable(GL_STENCIL_TEST);
    glDepthFunc(GL_LESS);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    draw(ambient_);

    glEnable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_CLAMP);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glStencilFunc(GL_ALWAYS, 0, 0xff);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    draw(volume_);
    glDisable(GL_DEPTH_CLAMP);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    glStencilFunc(GL_EQUAL, 0, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glDepthFunc(GL_EQUAL);
    draw(lit_);
    glDepthMask(GL_TRUE);
    glFinish();
}

}  // namespace scanlight::peers
