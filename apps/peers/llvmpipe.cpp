#include "apps/peers/llvmpipe.h"

#include <cstddef>
#include <span>
#include <stdexcept>

#include "apps/peers/gl_geometry.h"
#include "apps/peers/gl_program.h"
#include "apps/peers/gl_texture.h"
#include "render/frame.h"

namespace scanlight::peers {

namespace {

template <class T>
void fill_buffer(GLenum kind, GLuint buffer, const std::vector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

void set_attributes(int attributes) {
    const auto row = static_cast<GLsizei>(sizeof(float)) * 3 * attributes;
    for (int i = 0; i < attributes; ++i) {
        const auto number = static_cast<GLuint>(i);
        const auto begin = sizeof(float) * 3 * number;
        glEnableVertexAttribArray(number);
        glVertexAttribPointer(number, 3, GL_FLOAT, GL_FALSE, row,
                              reinterpret_cast<const void*>(begin));
    }
}

void set_culling(render::Cull cull) {
    if (cull == render::Cull::none) return glDisable(GL_CULL_FACE);
    glEnable(GL_CULL_FACE);
    glCullFace(cull == render::Cull::back ? GL_BACK : GL_FRONT);
    glFrontFace(GL_CW);  // y is turned round
}

void set_depth_test() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
}

GlGeometry geometry_of(const mesh::Mesh& mesh, render::Shading shading, Coat coat) {
    if (coat != Coat::none) return mapped_geometry(mesh);
    return shading == render::Shading::flat ? flat_geometry(mesh) : smooth_geometry(mesh);
}

}  // namespace

Llvmpipe::Llvmpipe(const GlTarget& target, const Stage& stage, const render::Settings& settings,
                   Coat coat)
    : target_(target),
      program_(gl_program(settings, coat, stage.scene().objects.front().materials.front(),
                          render::frame_of(stage.scene(), settings.distances, stage.size()))) {
    const GlGeometry geometry = geometry_of(stage.mesh(), settings.shading, coat);
    corners_ = static_cast<GLsizei>(geometry.corners.size());
    if (coat != Coat::none) texture_ = gl_texture(coat);
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    glGenBuffers(2, buffers_);
    fill_buffer(GL_ARRAY_BUFFER, buffers_[0], geometry.numbers);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1], geometry.corners);
    set_attributes(geometry.attributes);
    set_culling(settings.cull);
    set_depth_test();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    check_gl("uploading the mesh");
}

Llvmpipe::~Llvmpipe() {
    glDeleteBuffers(2, buffers_);
    glDeleteVertexArrays(1, &vertex_array_);
    glDeleteTextures(1, &texture_);
    glDeleteProgram(program_);
}

void Llvmpipe::draw() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr);
    glFinish();
}

}  // namespace scanlight::peers
