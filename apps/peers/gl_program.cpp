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
        case Illumination::cook_torrance:
            return "#define FACETS\n";
        default:
            throw std::invalid_argument("this illumination model is not in GLSL here");
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

std::string coat_definition(Coat coat) {
    if (coat == Coat::none) return {};
    return coat == Coat::bump ? "#define COAT\n#define BUMP\n" : "#define COAT\n#define TEXTURE\n";
}

/// All in which the programs differ, before the rest of each shader.
std::string definitions(const render::Settings& settings, Coat coat, const shading::Exponent& n) {
    return "#version 330 core\n" + power_definition(n) +
           highlight_definition(settings.illumination) + view_definition(settings.distances) +
           vertex_definitions(settings.shading) + coat_definition(coat);
}

const std::string illumination = R"(
uniform vec3 ambient, diffuse, specular, light, viewpoint;

#ifdef FACETS
uniform vec3 metal_n, metal_k;
uniform float m_squared;

vec3 reflectance(float c) {
    float c2 = c * c;
    float s2 = max(1.0 - c2, 0.0);
    vec3 a = ((metal_n - 1.0) * (metal_n + 1.0) - metal_k * metal_k) + c2;
    vec3 nk2 = 2.0 * metal_n * metal_k;
    vec3 q = sqrt(a * a + nk2 * nk2);
    vec3 pc2 = 2.0 * sqrt(max(q + a, 0.0) * 0.5) * c;
    vec3 perpendicular = (q + c2 - pc2) / (q + c2 + pc2);
    vec3 whole = c2 * q + s2 * s2;
    vec3 parallel = perpendicular * (whole - pc2 * s2) / (whole + pc2 * s2);
    return max(0.5 * (perpendicular + parallel), 0.0);
}

vec3 highlight(vec3 N, vec3 V, float n_l) {
    vec3 H = normalize(light + V);
    float n_v = dot(N, V);
    float n_h = dot(N, H);
    float v_h = dot(V, H);
    float c2 = n_h * n_h;
    float D = exp((c2 - 1.0) / (m_squared * c2)) / (m_squared * c2 * c2);
    float sure_n_v = max(n_v, 1e-4);
    float G = min(1.0, 2.0 * n_h * min(n_l, sure_n_v) / v_h);
    bool is_lit = n_l > 0.0 && n_v > 0.0 && n_h > 0.0;
    return is_lit ? reflectance(v_h) * (D * (G / sure_n_v)) : vec3(0.0);
}
#else
vec3 highlight(vec3 N, vec3 V, float n_l) {
    return vec3(n_l > 0.0 ? power(max(HIGHLIGHT, 0.0)) : 0.0);
}
#endif

vec3 illuminate(vec3 body, vec3 N, vec3 V) {
    float n_l = dot(N, light);
    return (ambient + diffuse * max(n_l, 0.0)) * body + specular * highlight(N, V, n_l);
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
    vec3 point = PLACE;
    color = illuminate(vec3(1.0), normal, VIEW);
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
#ifdef COAT
layout(location = 2) in vec3 place;
uniform float repeat;
out vec2 uv;
#endif

void main() {
    gl_Position = clip_from_world * vec4(position, 1.0);
#ifdef COAT
    uv = repeat * place.xy;
#endif
    point = position;
    interpolated_normal = normal;
}
)",
                              illumination + R"(
in vec3 point, interpolated_normal;
out vec4 pixel;
#ifdef COAT
uniform sampler2D image;
in vec2 uv;
#endif

#ifdef TEXTURE
#define BODY texture(image, uv).rgb
#else
#define BODY vec3(1.0)
#endif

#ifdef BUMP
uniform float bump_height;

vec3 height_gradient() {
    vec3 x = dFdx(point), y = dFdy(point);
    vec3 face = cross(x, y);
    mat2x3 to_space = mat2x3(cross(y, face), cross(face, x)) / dot(face, face);
    vec2 texels = vec2(textureSize(image, 0));
    vec2 slope = texels * texture(image, uv).rg;
    return to_space * vec2(dot(slope, dFdx(uv)), dot(slope, dFdy(uv))) * bump_height;
}

vec3 seen_normal(vec3 n, vec3 V) {
    vec3 g = height_gradient();
    vec3 bumped = normalize(n - (g - n * dot(n, g)));
    float along = dot(bumped, V);
    return along < 0.0 && dot(n, V) > 0.0 ? bumped - V * (2.0 * along) : bumped;
}
#else
#define seen_normal(n, V) (n)
#endif

void main() {
    vec3 V = VIEW;
    vec3 N = seen_normal(normalize(interpolated_normal), V);
    pixel = vec4(illuminate(BODY, N, V), 1.0);
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

void set_float(GLuint program, const char* name, float value) {
    glUniform1f(glGetUniformLocation(program, name), value);
}

/// What `highlight` leaves out that is the same everywhere, and the metal.
void set_facets(GLuint program, const shading::Microfacets& facets,
                const shading::Light<float>& light, const glm::vec3& diffuse) {
    const auto& slopes = facets.slopes;
    const auto constant = static_cast<float>(shading::pi * facets.share * slopes.constant() *
                                             slopes.reflection_constant());
    set_vec3(program, "diffuse", light.intensity * diffuse * static_cast<float>(1 - facets.share));
    set_vec3(program, "specular", light.intensity * constant);
    set_vec3(program, "metal_n", facets.reflectance.n);
    set_vec3(program, "metal_k", facets.reflectance.k);
    set_float(program, "m_squared", static_cast<float>(slopes.m() * slopes.m()));
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

GLuint gl_program(const render::Settings& settings, Coat coat,
                  const shading::Material<float>& material, const render::Frame& frame) {
    const std::string begin = definitions(settings, coat, material.exponent);
    const auto& [vertex, fragment] = sources_of(settings.shading);
    const GLuint program = gl_program({begin + vertex, begin + fragment}, material, frame);
    if (settings.illumination == Illumination::cook_torrance)
        set_facets(program, material.facets, frame.lighting.lights.front(), material.diffuse);
    set_float(program, "repeat", coat_repeat);
    set_float(program, "bump_height", coat_height);
    return program;
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
