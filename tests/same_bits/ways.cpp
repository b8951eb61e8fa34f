#include "tests/same_bits/ways.h"

#include "render/opacity.h"
#include "render/shadows.h"

namespace scanlight::same_bits {

std::vector<render::Renderer> renderers(std::span<const int> threads) {
    std::vector<render::Renderer> all;
    for (const std::string_view instructions : render::instruction_sets()) {
        for (const int count : threads)
            all.emplace_back(render::Execution{count, instructions});
    }
    return all;
}

std::string name_of(const render::Renderer& renderer) {
    return std::string(renderer.instructions()) + ", " + std::to_string(renderer.threads()) +
           " threads";
}

render::Drawing draw(const TestScene& test, render::Renderer& renderer) {
    // Neither the background's colour nor its depth: each pixel is to be written.
    render::Drawing drawing{raster::Framebuffer(test.size, raster::Rgba(-7.0f)), {}};
    drawing.framebuffer.depth = raster::Plane<raster::Depth>(test.size, -7);
    drawing.counts =
        renderer
            .draw(test.scene, test.settings, drawing.framebuffer.color, &drawing.framebuffer.depth)
            .counts;
    return drawing;
}

render::Drawing draw(const TestScene& test) {
    return render::draw(test.scene, test.settings, test.size);
}

std::vector<render::Stencil> count_shadows(const TestScene& test, render::Renderer& renderer) {
    if (!render::counts_volumes(test.settings.shadows)) return {};
    return renderer.count_shadows(test.scene, test.settings, test.size);
}

std::vector<render::Stencil> count_shadows(const TestScene& test, render::Shadows method) {
    if (!render::counts_volumes(method)) return {};
    render::Settings settings = test.settings;
    settings.shadows = method;
    const render::SplitScene scenes = render::split_by_opacity(test.scene);
    const render::Drawing seen = render::draw_depth(scenes.opaque, settings, test.size);
    std::vector<render::Stencil> stencils;
    for (std::size_t light = 0; light < test.scene.lighting.lights.size(); ++light)
        stencils.push_back(
            render::count_shadows(scenes.opaque, settings, light, seen.framebuffer.depth));
    return stencils;
}

std::vector<render::Stencil> count_shadows(const TestScene& test) {
    return count_shadows(test, test.settings.shadows);
}

}  // namespace scanlight::same_bits
