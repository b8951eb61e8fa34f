#include "apps/peers/gl_program.h"

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <glm/gtc/type_ptr.hpp>

namespace scanlight::peers {

namespace {

using shading::Illumination;

/// See shading/power.h.
std::string power_definition(const shading::Exponent& n) {
    std::string steps;
    if (n.is_whole() && n.whole() > 0) {
        steps = "float p = x;";
        for (std::uint32_t bit = std::bit_floor(n.whole()) >> 1; bit != 0; bit >>= 1)
            steps += (n.whole() & bit) != 0 ? " p *= p; p *= x;" : " p *= p;";
    } else {
        steps = "float p = pow(x, " + std::to_string(n.value()) + ");";
    }
    return "float power(float x) { " + steps + " return p; }\n";
}

std::string highlight_definition(Illumination model) {
    switch (model) {
        case Illumination::phong:
            return "#define HIGHLIGHT dot(2.0 * dot(N, light) * N - light, V)\n";
        case Illumination::blinn:
            return "#define HIGHLIGHT dot(N, normalize(light + V))\n";
        default:
            throw std::invalid_argument("only Phong's and Blinn's models are in GLSL here");
    }
}

/// An eye at infinity is seen in the same direction from everywhere.
std::string view_definition(render::Distances distances) {
    return distances == render::Distances::finite ? "#define VIEW normalize(viewpoint - point)\n"
                                                  : "#define VIEW viewpoint\n";
}

/// How the colour of a vertex is interpolated, and where the vertex is lit.
std::string vertex_definitions(render::Shading shading) {
    return shading == render::Shading::flat
               ? "#define INTERPOLATED flat\n#define PLACE middle\n"
               : "#define INTERPOLATED smooth\n#define PLACE position\n";
}

/// All in which the programs differ, before the rest of each shader.
std::string definitions(const render::Settings& settings, const shading::Exponent& n) {
    return "#version 330 core\n" + power_definition(n) +
           highlight_definition(settings.illumination) + view_definition(settings.distances) +
           vertex_definitions(settings.shading);
}

const std::string illumination = R"(
uniform vec3 ambient, diffuse, specular, light, viewpoint;

vec3 illuminate(vec3 point, vec3 N) {
    vec3 V = VIEW;
    float n_l = dot(N, light);
    float highlight = n_l > 0.0 ? power(max(HIGHLIGHT, 0.0)) : 0.0;
    return ambient + diffuse * max(n_l, 0.0) + specular * highlight;
}
)";

const GlSources lit_at_vertices{illumination + R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 middle;
uniform mat4 clip_from_world;
INTERPOLATED out vec3 color;

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    color = illuminate(PLACE, normal);
}
)",
                                R"(
INTERPOLATED in vec3 color;
out vec4 pixel;

void main() {
    pixel = vec4(color, 1.0);
}
)"};

const GlSources lit_at_pixels{R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_world;
out vec3 point, interpolated_normal;

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
    point = position;
    interpolated_normal = normal;
}
)",
                              illumination + R"(
in vec3 point, interpolated_normal;
out vec4 pixel;

void main() {
    pixel = vec4(illuminate(point, normalize(interpolated_normal)), 1.0);
}
)"};

const GlSources& sources_of(render::Shading shading) {
    return shading == render::Shading::phong ? lit_at_pixels : lit_at_vertices;
}

void attach_shader(GLuint program, GLenum kind, const std::string& source) {
    const GLuint shader = glCreateShader(kind);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // when the program is
}

void link(GLuint program) {
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
    throw std::runtime_error("GLSL: " + log.substr(0, static_cast<std::size_t>(length)));
}

void set_vec3(GLuint program, const char* name, const glm::vec3& value) {
    glUniform3fv(glGetUniformLocation(program, name), 1, glm::value_ptr(value));
}

/// OpenGL's clip space has its depth from -w to w, and y upward: with y turned round its lowest row
/// is our first.
glm::dmat4 gl_from_clip() {
    glm::dmat4 m(1.0);
    m[1][1] = -1.0;
    m[2][2] = 2.0;
    m[3][2] = -1.0;
    return m;
}

void set_uniforms(GLuint program, const shading::Material<float>& material,
                  const render::Frame& frame) {
    const auto& [ambient, lights] = frame.lighting;
    const glm::mat4 clip_from_world(gl_from_clip() * frame.clip_from_world);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip_from_world"), 1, GL_FALSE,
                       glm::value_ptr(clip_from_world));
    set_vec3(program, "ambient", ambient * material.ambient);
    set_vec3(program, "diffuse", lights.front().intensity * material.diffuse);
    set_vec3(program, "specular", lights.front().intensity * material.specular);
    set_vec3(program, "light", lights.front().place);
    const glm::vec3 viewpoint(frame.viewpoint);
    set_vec3(program, "viewpoint",
             frame.viewpoint.w == 0.0f ? shading::unit(viewpoint) : viewpoint);
}

}  // namespace

GLuint gl_program(const render::Settings& settings, const shading::Material<float>& material,
                  const render::Frame& frame) {
    const std::string begin = definitions(settings, material.exponent);
    const auto& [vertex, fragment] = sources_of(settings.shading);
    return gl_program({begin + vertex, begin + fragment}, material, frame);
}

GLuint gl_program(const GlSources& sources, const shading::Material<float>& material,
                  const render::Frame& frame) {
    const GLuint program = glCreateProgram();
    attach_shader(program, GL_VERTEX_SHADER, sources.vertex);
    attach_shader(program, GL_FRAGMENT_SHADER, sources.fragment);
    link(program);
    glUseProgram(program);
    set_uniforms(program, material, frame);
    return program;
}

}  // namespace scanlight::peers
