#include "render/renderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "raster/workers.h"
#include "render/band_drawer.h"
#include "render/draw.h"
#include "render/gouraud.h"
#include "render/light_view.h"
#include "render/opacity.h"
#include "render/shadow_map.h"
#include "render/shadow_volume.h"
#include "render/shadows.h"
#include "render/walker.h"

namespace scanlight::render {

namespace {

// Stretches of work: multiples of any vector's length.
constexpr std::size_t vertices_a_piece = 8192;
constexpr std::size_t faces_a_piece = 16384;

using Clock = std::chrono::steady_clock;

/// Seconds since `begin`, which becomes now.
double lap(Clock::time_point& begin) {
    const auto now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(begin, now)).count();
}

const LanePath& path_named(std::string_view name) {
    for (const LanePath* path : lane_paths()) {
        if (name.empty() || path->raster->name == name) return *path;
    }
    throw std::invalid_argument("no instruction set \"" + std::string(name) + "\" on this machine");
}

/// A stretch of one object's vertices or faces.
struct Piece {
    ObjectPass* pass;
    std::size_t begin;
    std::size_t end;
    std::size_t number;  // among those of the object
};

std::vector<Piece> pieces_of(std::span<ObjectPass> passes, std::size_t size, auto&& count_of) {
    std::vector<Piece> pieces;
    for (ObjectPass& pass : passes) {
        const std::size_t count = count_of(pass);
        for (std::size_t i = 0; i * size < count; ++i)
            pieces.push_back({&pass, i * size, std::min(count, i * size + size), i});
    }
    return pieces;
}

}  // namespace

struct Renderer::Memory {
    explicit Memory(const Execution& execution)
        : path(path_named(execution.instructions)),
          workers(execution.threads),
          survivors(static_cast<std::size_t>(workers.count())),
          bands(static_cast<std::size_t>(workers.count())) {}

    const LanePath& path;
    raster::Workers workers;
    std::vector<raster::Survivors> survivors;  // one a thread
    std::vector<BandDrawer> bands;             // one a thread
    std::vector<ObjectPass> passes;
    raster::Plane<raster::Rgba> floats;  // of a picture with transparent surfaces
    std::vector<ShadowMap> maps;         // of each light

    std::size_t bytes() const {
        std::size_t sum = floats.values().size_bytes();
        for (const ShadowMap& map : maps)
            sum += map.bytes();
        for (const ObjectPass& pass : passes)
            sum += pass.bytes();
        for (const raster::Survivors& scratch : survivors)
            sum += scratch.bytes();
        for (const BandDrawer& band : bands)
            sum += band.bytes();
        return sum;
    }
};

/// One picture on its way.
class Renderer::Picture {
public:
    /// Those of the scene's objects that are transparent come after the `opaque` ones.
    Picture(Memory& memory, const Scene& scene, std::size_t opaque, const Settings& settings,
            const Target& target, raster::Plane<raster::Depth>* depth,
            std::span<Stencil> stencils = {})
        : memory_(memory),
          scene_(scene),
          opaque_(opaque),
          settings_(settings),
          target_(target),
          depth_(depth),
          stencils_(stencils),
          frame_(frame_of(scene, settings.distances,
                          size_in_samples(size_of(target), settings.grid))) {}

    DrawReport draw() {
        DrawReport report;
        auto time = Clock::now();
        place_objects();
        light_vertices();
        cut_into_bands();
        report.seconds.vertices = lap(time);
        fill_bins();
        report.seconds.bins = lap(time);
        find_shadows();
        report.seconds.shadows = lap(time);
        draw_bands();
        report.seconds.bands = lap(time);
        report.counts = counts();
        report.working_bytes = memory_.bytes();
        return report;
    }

private:
    void place_objects() {
        memory_.passes.resize(scene_.objects.size());
        std::size_t faces = 0;
        for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
            memory_.passes[i].begin(scene_.objects[i], faces, frame_, settings_);
            faces += scene_.objects[i].mesh->face_count();
        }
        std::vector<std::atomic<std::int32_t>> outside(memory_.passes.size());
        for_each_piece(memory_.passes, vertices_a_piece, vertex_count,
                       [&](int, const Piece& piece) {
                           outside[static_cast<std::size_t>(piece.pass - memory_.passes.data())] |=
                               memory_.path.place_vertices(*piece.pass, piece.begin, piece.end);
                       });
        for (std::size_t i = 0; i < outside.size(); ++i)
            memory_.passes[i].polygons.outside_of_any = outside[i];
    }

    void light_vertices() {
        for (ObjectPass& pass : memory_.passes) {
            if (pass.settings.shading == Shading::gouraud) light_vertices_of(pass);
            pass.end_vertices();
        }
    }

    void light_vertices_of(ObjectPass& pass) {
        pass.begin_vertex_light();
        std::vector<float> largest(memory_.bands.size(), 0.0f);  // of each thread
        for_each_piece(
            {&pass, 1}, vertices_a_piece, vertex_count, [&](int worker, const Piece& piece) {
                float& most = largest[static_cast<std::size_t>(worker)];
                most = std::max(most, memory_.path.light_vertices(pass, piece.begin, piece.end));
            });
        pass.unit = unit_for(*std::ranges::max_element(largest));
    }

    void cut_into_bands() {
        bands_ = raster::bands_in_cache(frame_.viewport, 1 + picture().kept());
    }

    void fill_bins() {
        for (ObjectPass& pass : memory_.passes)
            pass.bins.resize((pass.mesh().face_count() + faces_a_piece - 1) / faces_a_piece);
        for_each_piece(
            memory_.passes, faces_a_piece, face_count, [&](int worker, const Piece& piece) {
                ObjectPass& pass = *piece.pass;
                if (!pass.face_uvs.empty())
                    memory_.path.find_face_uvs(pass, piece.begin, piece.end);
                const Cull cull = pass.settings.cull;
                const raster::CullRule rule{cull == Cull::front, cull == Cull::back};
                raster::fill_bin(
                    pass.polygons, rule, piece.begin, piece.end, bands_,
                    memory_.path.raster->cull_faces,
                    [&](std::size_t face) { return clipped_face(pass, face); },
                    memory_.survivors[static_cast<std::size_t>(worker)], pass.bins[piece.number]);
            });
    }

    void find_shadows() {
        find_sides(counts_volumes(settings_.shadows) ? frame_.lighting.lights.size() : 0);
        memory_.maps.clear();
        if (settings_.shadows == Shadows::map) draw_maps();
    }

    void find_sides(std::size_t lights) {
        for (ObjectPass& pass : opaque())
            pass.begin_shadows(lights);
        memory_.workers.for_each(opaque_ * lights, [&](int, std::size_t i) {
            ObjectPass& pass = memory_.passes[i / lights];
            const std::size_t light = i % lights;
            pass.sides[light].find(pass, homogeneous(frame_.lighting.lights[light]), bands_);
        });
    }

    void draw_maps() {
        const auto end = scene_.objects.begin() + static_cast<std::ptrdiff_t>(opaque_);
        const std::vector<Object> casters(scene_.objects.begin(), end);
        std::vector<std::pair<std::size_t, std::size_t>> views;  // of which map, and which of it
        for (const auto& light : frame_.lighting.lights) {
            const std::size_t map = memory_.maps.size();
            memory_.maps.emplace_back(casters, homogeneous(light), settings_.shadow_map);
            for (std::size_t view = 0; view < memory_.maps.back().view_count(); ++view)
                views.emplace_back(map, view);
        }
        memory_.workers.for_each(views.size(), [&](int, std::size_t i) {
            memory_.maps[views[i].first].draw(views[i].second, casters);
        });
    }

    void draw_bands() {
        for (BandDrawer& band : memory_.bands)
            band.begin();
        const BandDrawer::Picture all = picture();
        memory_.workers.for_each(
            static_cast<std::size_t>(bands_.count()), [&](int worker, std::size_t i) {
                const int number = static_cast<int>(i);
                BandDrawer& band = memory_.bands[static_cast<std::size_t>(worker)];
                band.draw(all, frame_.viewport.width, bands_[number], number);
            });
    }

    DrawCounts counts() const {
        DrawCounts counts;
        for (const ObjectPass& pass : memory_.passes) {
            counts.polygons += pass.mesh().face_count();
            for (const raster::Bin& bin : pass.bins) {
                counts.outside += bin.fates.outside;
                counts.culled += bin.fates.culled;
                counts.drawn += bin.fates.drawn;
            }
        }
        for (const BandDrawer& band : memory_.bands)
            band.add_to(counts);
        return counts;
    }

    /// As the bands share it.
    BandDrawer::Picture picture() const {
        const auto passes = std::span<const ObjectPass>(memory_.passes);
        return {memory_.path,
                passes.first(opaque_),
                passes.subspan(opaque_),
                frame_,
                memory_.maps,
                settings_,
                scene_.background,
                target_,
                light_at_once(passes, target_),
                depth_,
                stencils_};
    }

    std::span<ObjectPass> opaque() { return std::span(memory_.passes).first(opaque_); }

    static std::size_t vertex_count(const ObjectPass& pass) { return pass.mesh().vertices.size(); }
    static std::size_t face_count(const ObjectPass& pass) { return pass.mesh().face_count(); }

    template <class Count, class Work>
    void for_each_piece(std::span<ObjectPass> passes, std::size_t size, Count count, Work&& work) {
        const std::vector<Piece> pieces = pieces_of(passes, size, count);
        memory_.workers.for_each(pieces.size(),
                                 [&](int worker, std::size_t i) { work(worker, pieces[i]); });
    }

    Memory& memory_;
    const Scene& scene_;
    std::size_t opaque_;
    const Settings& settings_;
    const Target& target_;
    raster::Plane<raster::Depth>* depth_;
    std::span<Stencil> stencils_;
    Frame frame_;
    raster::Bands bands_;
};

namespace {

/// A bit a light for each pixel: no share of it. The maps of all lights are there at one time.
bool knows_maps(const Scene& scene, const Settings& settings) {
    constexpr std::size_t most = std::size_t{1} << 28;  // bytes
    return settings.shadow_map.filter == 1 &&
           most_bytes(scene.lighting.lights, settings.shadow_map) <= most;
}

/// Intensities of the vertices would have to be interpolated for each light apart.
bool knows_shadows(const Scene& scene, const Settings& settings) {
    const auto is_gouraud = [&](const Object& object) {
        return settings_of(object, settings).shading == Shading::gouraud;
    };
    if (std::ranges::any_of(scene.objects, is_gouraud) ||
        scene.lighting.lights.size() > ShadowBand::most_lights)
        return false;
    if (settings.shadows == Shadows::map) return knows_maps(scene, settings);
    return counts_volumes(settings.shadows) && sides_suffice(scene, settings);
}

/// What the fast path does not know.
DrawReport draw_by_the_textbook(const Scene& scene, const Settings& settings, const Target& target,
                                raster::Plane<raster::Depth>* depth) {
    Drawing drawing = draw(scene, settings, size_of(target));
    for (int y = 0; y < drawing.framebuffer.color.height(); ++y)
        store_colors(drawing.framebuffer.color.row(y), y, target);
    if (depth != nullptr) *depth = std::move(drawing.framebuffer.depth);
    DrawReport report;
    report.counts = drawing.counts;
    return report;
}

std::vector<Stencil> count_by_the_textbook(const Scene& scene, const Settings& settings,
                                           raster::Viewport viewport) {
    const Drawing drawing = draw_depth(scene, settings, viewport);
    std::vector<Stencil> stencils;
    for (std::size_t light = 0; light < scene.lighting.lights.size(); ++light)
        stencils.push_back(count_shadows(scene, settings, light, drawing.framebuffer.depth));
    return stencils;
}

}  // namespace

DrawReport Renderer::draw_into(const Scene& scene, const Settings& settings, const Target& target,
                               raster::Plane<raster::Depth>* depth) {
    if (settings.shadows != Shadows::none && !knows_shadows(scene, settings))
        return draw_by_the_textbook(scene, settings, target, depth);
    if (settings.grid > 1 && depth != nullptr)
        *depth = draw_opaque_depth(scene, settings, size_of(target)).framebuffer.depth;
    raster::Plane<raster::Depth>* const drawn_depth = settings.grid > 1 ? nullptr : depth;
    if (has_transparent(scene)) return draw_layers_into(scene, settings, target, drawn_depth);
    return Picture(*memory_, scene, scene.objects.size(), settings, target, drawn_depth).draw();
}

DrawReport Renderer::draw_layers_into(const Scene& scene, const Settings& settings,
                                      const Target& target, raster::Plane<raster::Depth>* depth) {
    SplitScene split = split_by_opacity(scene);
    const std::size_t opaque = split.opaque.objects.size();
    std::ranges::move(split.transparent.objects, std::back_inserter(split.opaque.objects));
    if (std::holds_alternative<FloatTarget>(target) || settings.grid > 1)  // samples are floats
        return Picture(*memory_, split.opaque, opaque, settings, target, depth).draw();
    const raster::Viewport size = size_of(target);
    raster::Plane<raster::Rgba>& floats = memory_->floats;
    if (floats.width() != size.width || floats.height() != size.height)
        floats = {size, raster::Rgba(0.0f)};
    const FloatTarget first{&floats, scene.background};
    const DrawReport report =
        Picture(*memory_, split.opaque, opaque, settings, first, depth).draw();
    memory_->workers.for_each(static_cast<std::size_t>(size.height), [&](int, std::size_t y) {
        store_colors(floats.row(static_cast<int>(y)), static_cast<int>(y), target);
    });
    return report;
}

std::vector<Stencil> Renderer::count_shadows(const Scene& scene, const Settings& picture,
                                             raster::Viewport viewport) {
    const SplitScene split = split_by_opacity(scene);
    const Scene& opaque = split.opaque;
    Settings settings = picture;
    settings.grid = 1;
    if (!knows_shadows(opaque, settings)) return count_by_the_textbook(opaque, settings, viewport);
    std::vector<Stencil> stencils(scene.lighting.lights.size(), Stencil(viewport, 0));
    raster::Plane<raster::Rgba> color(viewport, scene.background);
    const FloatTarget target{&color, scene.background};
    Picture(*memory_, opaque, opaque.objects.size(), settings, target, nullptr, stencils).draw();
    return stencils;
}

std::vector<std::string_view> instruction_sets() {
    std::vector<std::string_view> names;
    for (const LanePath* path : lane_paths())
        names.push_back(path->raster->name);
    return names;
}

Renderer::Renderer(const Execution& execution) : memory_(std::make_unique<Memory>(execution)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

int Renderer::threads() const {
    return memory_->workers.count();
}

std::string_view Renderer::instructions() const {
    return memory_->path.raster->name;
}

DrawReport Renderer::draw(const Scene& scene, const Settings& settings,
                          raster::Plane<raster::Rgba>& color, raster::Plane<raster::Depth>* depth) {
    return draw_into(scene, settings, FloatTarget{&color, scene.background}, depth);
}

DrawReport Renderer::draw(const Scene& scene, const Settings& settings,
                          raster::Plane<raster::PackedPixel>& color, raster::Encoding encoding,
                          raster::Plane<raster::Depth>* depth) {
    const PackedTarget target{&color, encoding, raster::packed_pixel(scene.background, encoding)};
    return draw_into(scene, settings, target, depth);
}

}  // namespace scanlight::render
