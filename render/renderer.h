#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "raster/framebuffer.h"
#include "raster/packed.h"
#include "render/draw_polygons.h"
#include "render/lane_path.h"
#include "render/scene.h"

namespace scanlight::render {

/// By what means a picture is drawn. None of it changes a bit of the picture.
struct Execution {
    int threads = 0;                // 0: one for each processor
    std::string_view instructions;  // a name of `instruction_sets`; empty: the fastest
};

/// The vector instruction sets that this program knows and this machine runs, the fastest first.
std::vector<std::string_view> instruction_sets();

/// Seconds a stage took.
struct StageTimes {
    double vertices = 0.0;  // placed and, for Gouraud, lit
    double bins = 0.0;      // polygons culled and sorted into bands
    double shadows = 0.0;   // volumes found and clipped, or maps drawn
    double bands = 0.0;     // rasterized and shaded
};

struct DrawReport {
    DrawCounts counts;
    StageTimes seconds;
    std::size_t working_bytes = 0;  // memory held besides the scene and the picture
};

/// The fast path: draws what `draw` draws, to the bit, by vectors and threads. First the vertices,
/// many at a time; then polygons are culled and sorted into bands of rows; then each thread takes
/// one band after the other, finds out what each pixel shows, and only then lights the pixels. See
/// docs/fast-path.md. Some shadows it leaves to `draw`: of Gouraud shading; by volumes those of
/// culled polygons and of polygons of more than four corners; by maps those that are filtered, or
/// take more than 256 MiB; all by polygons. Keeps its threads and its memory from one picture to
/// the next; not for two callers at once.
class Renderer {
public:
    /// Throws std::invalid_argument for instructions that this machine does not run.
    explicit Renderer(const Execution& execution = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    int threads() const;
    std::string_view instructions() const;

    /// The picture as floats; and its depths where `depth` is not null. Planes are of one size.
    DrawReport draw(const Scene& scene, const Settings& settings,
                    raster::Plane<raster::Rgba>& color, raster::Plane<raster::Depth>* depth = {});

    /// The picture as bytes: the same as the floats, clamped and rounded.
    DrawReport draw(const Scene& scene, const Settings& settings,
                    raster::Plane<raster::PackedPixel>& color, raster::Encoding encoding,
                    raster::Plane<raster::Depth>* depth = {});

    /// What is counted in the stencil to draw the scene with its shadows, for each light: what
    /// `count_shadows` counts.
    std::vector<Stencil> count_shadows(const Scene& scene, const Settings& settings,
                                       raster::Viewport viewport);

private:
    DrawReport draw_into(const Scene& scene, const Settings& settings, const Target& target,
                         raster::Plane<raster::Depth>* depth);
    DrawReport draw_layers_into(const Scene& scene, const Settings& settings, const Target& target,
                                raster::Plane<raster::Depth>* depth);

    class Picture;
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace scanlight::render
