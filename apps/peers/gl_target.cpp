#include "apps/peers/gl_target.h"

#include <array>
#include <stdexcept>

namespace scanlight::peers {

namespace {

OSMesaContext new_context() {
    constexpr std::array attributes{OSMESA_FORMAT,
                                    OSMESA_RGBA,
                                    OSMESA_PROFILE,
                                    OSMESA_CORE_PROFILE,
                                    OSMESA_CONTEXT_MAJOR_VERSION,
                                    3,
                                    OSMESA_CONTEXT_MINOR_VERSION,
                                    3,
                                    0};
    return OSMesaCreateContextAttribs(attributes.data(), nullptr);
}

void attach(GLenum attachment, GLenum format, raster::Viewport size) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

void bind_framebuffer(raster::Viewport size, GlTarget::Stencil stencil) {
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, size);
    if (stencil == GlTarget::Stencil::none) {
        attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, size);
    } else {
        attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, size);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OSMesa: incomplete framebuffer");
    glViewport(0, 0, size.width, size.height);
}

}  // namespace

GlTarget::GlTarget(raster::Viewport size, Stencil stencil) : size_(size), context_(new_context()) {
    if (context_ == nullptr || !OSMesaMakeCurrent(context_, &unused_, GL_UNSIGNED_BYTE, 1, 1))
        throw std::runtime_error("OSMesa: no context for OpenGL 3.3");
    if (!renderer().starts_with("llvmpipe"))
        throw std::runtime_error("OSMesa draws by " + renderer() + ", not by llvmpipe");
    bind_framebuffer(size, stencil);
    check_gl("making the framebuffer");
}

GlTarget::~GlTarget() {
    OSMesaDestroyContext(context_);
}

std::string GlTarget::renderer() const {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

raster::Plane<raster::PackedPixel> GlTarget::picture() const {
    raster::Plane<raster::PackedPixel> plane(size_, 0);
    for (int y = 0; y < size_.height; ++y)
        glReadPixels(0, y, size_.width, 1, GL_RGBA, GL_UNSIGNED_BYTE, plane.row(y).data());
    check_gl("reading the picture");
    return plane;
}

void check_gl(const std::string& what) {
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL error " + std::to_string(error) + " in " + what);
}

}  // namespace scanlight::peers
