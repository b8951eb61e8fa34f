#include "apps/scanlight/picture.h"

#include "apps/scanlight/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "raster/image_of.h"
#include "raster/packed_image.h"
#include "render/draw.h"
#include "render/draw_details.h"
#include "render/frame.h"
#include "render/light_view.h"
#include "render/shadows.h"
#include "render/wireframe.h"

namespace scanlight::apps {

namespace {

constexpr raster::Rgba line_color{0.01f, 0.012f, 0.018f, 1.0f};
constexpr std::array<raster::Rgba, 4> detail_colors{{{0.9f, 0.5f, 0.02f, 1.0f},
                                                     {0.02f, 0.25f, 0.9f, 1.0f},
                                                     {0.1f, 0.6f, 0.1f, 1.0f},
                                                     {0.7f, 0.05f, 0.4f, 1.0f}}};

Picture by_textbook(render::Drawing drawing) {
    Picture picture;
    picture.color = std::move(drawing.framebuffer.color);
    picture.depth = std::move(drawing.framebuffer.depth);
    picture.report.drawing.counts = drawing.counts;
    return picture;
}

/// Draws straight into the samples wanted.
Picture by_fast_path(const render::Scene& scene, const SceneOptions& options,
                     const render::Execution& execution, Wanted wanted) {
    render::Renderer renderer(execution);
    Picture picture;
    picture.report = {DrawPath::fast, renderer.threads(), renderer.instructions(), {}};
    raster::Plane<raster::Depth>* depth = nullptr;
    if (wanted.depth) depth = &picture.depth.emplace(options.size, raster::depth_clear);
    if (wanted.samples == Samples::floats) {
        auto& color = picture.color.emplace<Picture::Floats>(options.size, scene.background);
        picture.report.drawing = renderer.draw(scene, options.settings, color, depth);
    } else {
        auto& color = picture.color.emplace<Picture::Bytes>(options.size, 0);
        picture.report.drawing =
            renderer.draw(scene, options.settings, color, raster::Encoding::srgb, depth);
    }
    return picture;
}

Picture shaded(const render::Scene& scene, const SceneOptions& options, const Means& means,
               Wanted wanted) {
    if (means.path == DrawPath::fast) return by_fast_path(scene, options, means.execution, wanted);
    return by_textbook(render::draw(scene, options.settings, options.size));
}

/// A picture of floats and depths with what `draw(framebuffer)` draws over it.
template <class Draw>
Picture with_lines(Picture picture, Draw&& draw) {
    auto& color = std::get<Picture::Floats>(picture.color);
    raster::Framebuffer target({1, 1}, raster::Rgba(0.0f));
    std::swap(target.color, color);
    std::swap(target.depth, *picture.depth);
    draw(target);
    std::swap(target.color, color);
    std::swap(target.depth, *picture.depth);
    return picture;
}

/// The edges of polygons.
Picture with_edges(Picture picture, const render::Scene& scene, const SceneOptions& options,
                   render::HiddenLines hidden) {
    return with_lines(std::move(picture), [&](raster::Framebuffer& target) {
        render::draw_wireframe(scene, line_color, hidden, target, options.settings);
    });
}

/// The outlines of the lit details of each light, in colours of their own.
Picture with_details(Picture picture, const render::Scene& scene, const SceneOptions& options) {
    const auto lights =
        render::frame_of(scene, options.settings.distances, options.size).lighting.lights;
    return with_lines(std::move(picture), [&](raster::Framebuffer& target) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const auto details =
                render::detail_polygons(scene.objects, render::homogeneous(lights[i]));
            render::draw_detail_outlines(scene, details, detail_colors[i % detail_colors.size()],
                                         target);
        }
    });
}

template <std::size_t count>
void unpack(raster::PackedPixel pixel, std::uint8_t* samples) {
    for (std::size_t k = 0; k < count; ++k)
        samples[k] = static_cast<std::uint8_t>(pixel >> (8 * k));
}

/// All four bytes of a pixel are one store, which is faster than three: the next pixel overwrites
/// what is too much, and only the last one needs care. A row has one pixel at least.
template <std::size_t channels>
void unpack_row(std::span<const raster::PackedPixel> row, std::span<std::uint8_t> samples) {
    std::uint8_t* to = samples.data();
    for (const raster::PackedPixel pixel : row.first(row.size() - 1)) {
        unpack<4>(pixel, to);
        to += channels;
    }
    unpack<channels>(row.back(), to);
}

raster::Image8 unpacked(const Picture::Bytes& color, raster::Alpha alpha) {
    const bool kept = alpha == raster::Alpha::kept;
    raster::Image8 image(color.width(), color.height(), kept ? 4 : 3);
    for (int y = 0; y < color.height(); ++y)
        (kept ? unpack_row<4> : unpack_row<3>)(color.row(y), image.row(y));
    return image;
}

/// The heat map of the stencil in the place of the colours.
Picture stencil_picture(const render::Scene& scene, const SceneOptions& options) {
    Picture picture;
    picture.color = raster::packed_image(heat_map(draw_stencil(scene, options)));
    return picture;
}

/// What the options ask for, but for the edges of polygons.
Picture shown(const render::Scene& scene, const SceneOptions& options, const Means& means,
              Wanted wanted) {
    switch (options.show) {
        case Show::light:
            return shaded(scene, options, means, wanted);
        case Show::stencil:
            return stencil_picture(scene, options);
        case Show::fresnel:
            return by_textbook(render::draw_fresnel(scene, options.settings, options.size));
        case Show::details:
            return with_details(shaded(scene, options, means, {Samples::floats, true}), scene,
                                options);
    }
    return {};
}

}  // namespace

Picture draw_picture(const render::Scene& scene, const SceneOptions& options, const Means& means,
                     Wanted wanted) {
    const auto only_depth = [&] {
        return by_textbook(render::draw_depth(scene, options.settings, options.size));
    };
    switch (wireframe_of(options)) {
        case Wireframe::none:
            return shown(scene, options, means, wanted);
        case Wireframe::all:
            return with_edges(only_depth(), scene, options, render::HiddenLines::shown);
        case Wireframe::hidden:
            return with_edges(only_depth(), scene, options, render::HiddenLines::removed);
        case Wireframe::over:
            return with_edges(shaded(scene, options, means, {Samples::floats, true}), scene,
                              options, render::HiddenLines::removed);
    }
    return {};
}

raster::AnyImage color_image(const Picture& picture, Samples samples, raster::Alpha alpha) {
    if (samples == Samples::bytes) return byte_image(picture, alpha);
    return raster::linear_image(std::get<Picture::Floats>(picture.color), alpha);
}

raster::Image8 byte_image(const Picture& picture, raster::Alpha alpha) {
    if (const auto* floats = std::get_if<Picture::Floats>(&picture.color)) {
        return raster::srgb_image(*floats, alpha);
    }
    return unpacked(std::get<Picture::Bytes>(picture.color), alpha);
}

raster::Image8 normals_image(const raster::Plane<glm::vec3>& normals) {
    return raster::image_of<std::uint8_t>(normals, 3, [](auto pixel, const glm::vec3& n) {
        if (n == glm::vec3(0.0f)) return;
        for (int k = 0; k < 3; ++k) {
            pixel[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(
                std::lrint(std::clamp(n[k] * 0.5f + 0.5f, 0.0f, 1.0f) * 255.0f));
        }
    });
}

raster::ImageF normals_float_image(const raster::Plane<glm::vec3>& normals) {
    return raster::image_of<float>(normals, 3, [](auto pixel, const glm::vec3& n) {
        for (int k = 0; k < 3; ++k)
            pixel[static_cast<std::size_t>(k)] = n[k];
    });
}

raster::Image8 ids_image(const raster::Plane<std::uint32_t>& ids) {
    return raster::image_of<std::uint8_t>(ids, 3, [](auto pixel, std::uint32_t id) {
        pixel[0] = static_cast<std::uint8_t>(id >> 16);
        pixel[1] = static_cast<std::uint8_t>(id >> 8);
        pixel[2] = static_cast<std::uint8_t>(id);
    });
}

raster::ImageF ids_float_image(const raster::Plane<std::uint32_t>& ids) {
    return raster::image_of<float>(
        ids, 1, [](auto pixel, std::uint32_t id) { pixel[0] = static_cast<float>(id); });
}

raster::Plane<std::int32_t> draw_stencil(const render::Scene& scene, const SceneOptions& options) {
    render::Settings settings = options.settings;
    settings.shadows = volumes_for("the stencil", options);
    const render::Drawing drawing = render::draw_depth(scene, settings, options.size);
    raster::Plane<std::int32_t> sum(options.size, 0);
    for (std::size_t i = 0; i < scene.lighting.lights.size(); ++i) {
        const auto counts = render::count_shadows(scene, settings, i, drawing.framebuffer.depth);
        for (int y = 0; y < sum.height(); ++y)
            std::ranges::transform(sum.row(y), counts.row(y), sum.row(y).begin(), std::plus<>{});
    }
    return sum;
}

raster::ImageF counts_float_image(const raster::Plane<std::int32_t>& counts) {
    return raster::image_of<float>(
        counts, 1, [](auto pixel, std::int32_t count) { pixel[0] = static_cast<float>(count); });
}

raster::ImageF float_image(const raster::Plane<float>& values) {
    return raster::image_of<float>(values, 1, [](auto pixel, float value) { pixel[0] = value; });
}

}  // namespace scanlight::apps
