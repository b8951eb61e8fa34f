#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "apps/scanlight/means.h"
#include "apps/scanlight/scene_options.h"
#include "raster/develop.h"
#include "raster/image.h"
#include "render/renderer.h"

namespace scanlight::apps {

/// The samples of a picture: sRGB bytes, or linear floats.
enum class Samples { bytes, floats };

/// What a picture is drawn for.
struct Wanted {
    Samples samples = Samples::bytes;
    bool depth = false;
};

/// How a picture came about.
struct PictureReport {
    DrawPath path = DrawPath::textbook;
    int threads = 1;
    std::string_view instructions;  // of the fast path
    render::DrawReport drawing;     // of the textbook's walk: the counts only
};

struct Picture {
    using Bytes = raster::Plane<raster::PackedPixel>;  // sRGB
    using Floats = raster::Plane<raster::Rgba>;

    std::variant<Bytes, Floats> color;
    std::optional<raster::Plane<raster::Depth>> depth;  // at least where it is wanted
    PictureReport report;
};

/// Draws the scene and, as the options ask, the edges of its polygons. Where those stand alone,
/// only the depth of the polygons counts, and the textbook's walk draws it.
Picture draw_picture(const render::Scene& scene, const SceneOptions& options, const Means& means,
                     Wanted wanted);

/// The colours as an image file takes them. `samples` are those that the picture was wanted for.
raster::AnyImage color_image(const Picture& picture, Samples samples, raster::Alpha alpha);

/// The colours in bytes, whatever the picture was wanted for.
raster::Image8 byte_image(const Picture& picture, raster::Alpha alpha);

/// Normals as colours: (n + 1) / 2 in 8 bits; black is the background.
raster::Image8 normals_image(const raster::Plane<glm::vec3>& normals);

/// World-space normals as floats.
raster::ImageF normals_float_image(const raster::Plane<glm::vec3>& normals);

/// Polygon numbers in 24 bits: red is the highest byte, blue the lowest; or as floats.
raster::Image8 ids_image(const raster::Plane<std::uint32_t>& ids);
raster::ImageF ids_float_image(const raster::Plane<std::uint32_t>& ids);

/// How many shadow volumes each pixel's surface lies in, of all lights together, by the options'
/// way to count; by z-fail where they name none.
raster::Plane<std::int32_t> draw_stencil(const render::Scene& scene, const SceneOptions& options);

/// Counts as floats.
raster::ImageF counts_float_image(const raster::Plane<std::int32_t>& counts);

/// One float a pixel.
raster::ImageF float_image(const raster::Plane<float>& values);

}  // namespace scanlight::apps
