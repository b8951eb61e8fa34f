#include "render/renderer.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <stdexcept>
#include <string>

#include "raster/workers.h"
#include "render/gouraud.h"
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

/// What one thread needs to draw a band.
struct BandMemory {
    raster::VisibleBand band;
    ShadeScratch shade;
    WalkMemories walks;
    raster::Survivors survivors;
    std::vector<raster::FaceItem> items;
    std::size_t shaded = 0;
};

/// A stretch of one object's vertices or faces.
struct Piece {
    ObjectPass* pass;
    std::size_t begin;
    std::size_t end;
    std::size_t number;  // among those of the object
};

std::vector<Piece> pieces_of(std::vector<ObjectPass>& passes, std::size_t size, auto&& count_of) {
    std::vector<Piece> pieces;
    for (ObjectPass& pass : passes) {
        const std::size_t count = count_of(pass);
        for (std::size_t i = 0; i * size < count; ++i)
            pieces.push_back({&pass, i * size, std::min(count, i * size + size), i});
    }
    return pieces;
}

bool is_lit_at_vertices(const Settings& settings) {
    return settings.shading == Shading::gouraud;
}

raster::AttributeStream colors_stream(const std::vector<float>& front,
                                      const std::vector<float>& back, float unit) {
    return {front.data(), back.empty() ? front.data() : back.data(), 1.0f / unit, 1.0f / unit};
}

raster::AttributeStream stream_of_both_sides(const std::vector<float>& stream, float back_scale) {
    return {stream.data(), stream.data(), 1.0f, back_scale};
}

/// What each shading interpolates: see the techniques.
raster::Attributes attributes_of(const ObjectPass& pass) {
    const mesh::Vertices& vertices = pass.mesh().vertices;
    raster::Attributes a;
    a.w = pass.vertices.w;
    a.perspective_correct = pass.settings->perspective == Perspective::correct;
    if (pass.settings->shading == Shading::gouraud) {
        a.streams[0] = colors_stream(pass.front.x, pass.back.x, pass.unit);
        a.streams[1] = colors_stream(pass.front.y, pass.back.y, pass.unit);
        a.streams[2] = colors_stream(pass.front.z, pass.back.z, pass.unit);
        a.count = 4;  // the last is the constant 1
    }
    if (pass.settings->shading == Shading::phong) {
        a.streams[0] = stream_of_both_sides(pass.vertices.normals.x, -1.0f);
        a.streams[1] = stream_of_both_sides(pass.vertices.normals.y, -1.0f);
        a.streams[2] = stream_of_both_sides(pass.vertices.normals.z, -1.0f);
        a.count = 3;
        if (vertices.has_colors()) {
            a.streams[3] = stream_of_both_sides(vertices.red, 1.0f);
            a.streams[4] = stream_of_both_sides(vertices.green, 1.0f);
            a.streams[5] = stream_of_both_sides(vertices.blue, 1.0f);
            a.count = 7;
        }
    }
    return a;
}

raster::PolygonStreams polygons_of(const ObjectPass& pass) {
    const VertexStreams& v = pass.vertices;
    return {v.x,
            v.y,
            v.z,
            v.outside,
            pass.mesh().corners,
            pass.mesh().face_begin,
            pass.placing.mirrored};
}

std::vector<std::int32_t> materials_of_vertices(const Object& object) {
    if (object.materials.size() == 1) return {};
    const auto materials = vertex_materials(*object.mesh);
    std::vector<std::int32_t> result(materials.begin(), materials.end());
    result.resize(result.size() + 64);  // whole vectors are read
    return result;
}

raster::Viewport size_of(const Target& target) {
    return std::visit(
        [](const auto& t) {
            return raster::Viewport{t.plane->width(), t.plane->height()};
        },
        target);
}

void fill_rows(const Target& target, raster::Rows rows) {
    std::visit(
        [&](const auto& t) {
            for (int y = rows.y_begin; y < rows.y_end; ++y)
                std::ranges::fill(t.plane->row(y), t.background);
        },
        target);
}

}  // namespace

namespace {

// Memory held by the vectors of each stage, in bytes.

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}

template <class... T>
std::size_t bytes_of_all(const std::vector<T>&... values) {
    return (bytes_of(values) + ... + 0);
}

std::size_t bytes_of(const VectorStreams& v) {
    return bytes_of_all(v.x, v.y, v.z);
}

std::size_t bytes_of(const ObjectPass& pass) {
    const VertexStreams& v = pass.vertices;
    std::size_t bytes = bytes_of_all(v.x, v.y, v.z, v.outside, pass.vertex_material) +
                        bytes_of(v.w) + bytes_of(v.points) + bytes_of(v.normals) +
                        bytes_of(pass.front) + bytes_of(pass.back);
    for (const raster::Bin& bin : pass.bins)
        bytes += bytes_of(bin.items) + bytes_of(bin.begin);
    return bytes;
}

std::size_t bytes_of(const BandMemory& memory) {
    return memory.band.bytes() + memory.shade.records.bytes() + bytes_of(memory.items) +
           bytes_of(memory.shade.face_colors) + bytes_of(memory.shade.row) +
           bytes_of_all(memory.survivors.item, memory.survivors.y_begin, memory.survivors.y_end);
}

}  // namespace

struct Renderer::Memory {
    explicit Memory(const Execution& execution)
        : path(path_named(execution.instructions)),
          workers(execution.threads),
          bands(static_cast<std::size_t>(workers.count())) {}

    const LanePath& path;
    raster::Workers workers;
    std::vector<BandMemory> bands;  // one a thread
    std::vector<ObjectPass> passes;

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const ObjectPass& pass : passes)
            sum += bytes_of(pass);
        for (const BandMemory& band : bands)
            sum += bytes_of(band);
        return sum;
    }
};

/// One picture on its way.
class Renderer::Picture {
public:
    Picture(Memory& memory, const Scene& scene, const Settings& settings, const Target& target,
            raster::Plane<raster::Depth>* depth)
        : memory_(memory),
          scene_(scene),
          settings_(settings),
          target_(target),
          depth_(depth),
          frame_(frame_of(scene, settings.distances, size_of(target))),
          bands_{frame_.viewport.height} {}

    DrawReport draw() {
        DrawReport report;
        auto time = Clock::now();
        place_objects();
        light_vertices();
        report.seconds.vertices = lap(time);
        fill_bins();
        report.seconds.bins = lap(time);
        draw_bands();
        report.seconds.bands = lap(time);
        report.counts = counts();
        report.working_bytes = memory_.bytes();
        return report;
    }

private:
    void place_objects() {
        memory_.passes.resize(scene_.objects.size());
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            begin_pass(scene_.objects[i], memory_.passes[i]);
        for_each_piece(vertices_a_piece, vertex_count, [&](int, const Piece& piece) {
            memory_.path.place_vertices(*piece.pass, piece.begin, piece.end);
        });
    }

    void begin_pass(const Object& object, ObjectPass& pass) {
        assert(object.materials.size() == object.mesh->materials.size());
        pass.object = &object;
        pass.frame = &frame_;
        pass.settings = &settings_;
        pass.placing = placing_of(object.world_from_object, frame_);
        pass.vertices.resize(object.mesh->vertices.size(), settings_.shading != Shading::phong,
                             settings_.shading != Shading::flat);
        pass.polygons = polygons_of(pass);
    }

    void light_vertices() {
        if (is_lit_at_vertices(settings_)) {
            for (ObjectPass& pass : memory_.passes)
                light_vertices_of(pass);
        }
        for (ObjectPass& pass : memory_.passes)
            pass.attributes = attributes_of(pass);
    }

    void light_vertices_of(ObjectPass& pass) {
        const std::size_t size = pass.vertices.w.size();
        pass.vertex_material = materials_of_vertices(*pass.object);
        pass.front.resize(size);
        pass.back.resize(settings_.sides == Sides::two ? size : 0);
        std::vector<float> largest(memory_.bands.size(), 0.0f);
        const std::size_t count = pass.mesh().vertices.size();
        const std::size_t pieces = (count + vertices_a_piece - 1) / vertices_a_piece;
        memory_.workers.for_each(pieces, [&](int worker, std::size_t i) {
            const std::size_t begin = i * vertices_a_piece;
            float& most = largest[static_cast<std::size_t>(worker)];
            most = std::max(most, memory_.path.light_vertices(
                                      pass, begin, std::min(count, begin + vertices_a_piece)));
        });
        pass.unit = unit_for(*std::ranges::max_element(largest));
    }

    void fill_bins() {
        for (ObjectPass& pass : memory_.passes)
            pass.bins.resize((pass.mesh().face_count() + faces_a_piece - 1) / faces_a_piece);
        const raster::CullRule rule{settings_.cull == Cull::front, settings_.cull == Cull::back};
        for_each_piece(faces_a_piece, face_count, [&](int worker, const Piece& piece) {
            ObjectPass& pass = *piece.pass;
            raster::fill_bin(
                pass.polygons, rule, piece.begin, piece.end, bands_,
                memory_.path.raster->cull_faces,
                [&](std::size_t face) { return clipped_face(pass, face); },
                memory_.bands[static_cast<std::size_t>(worker)].survivors, pass.bins[piece.number]);
        });
    }

    void draw_bands() {
        for (BandMemory& band : memory_.bands) {
            band.band.counts() = {};
            band.shaded = 0;
        }
        memory_.workers.for_each(
            static_cast<std::size_t>(bands_.count()), [&](int worker, std::size_t i) {
                draw_band(memory_.bands[static_cast<std::size_t>(worker)], static_cast<int>(i));
            });
    }

    void draw_band(BandMemory& memory, int number) {
        const raster::Rows rows = bands_[number];
        memory.band.clear(frame_.viewport.width, rows);
        Background background = Background::drawn;
        for (const ObjectPass& pass : memory_.passes) {
            see(pass, number, memory);
            if (memory.shade.records.count == 0) continue;
            shade(pass, memory, background);
            memory.band.forget_items();
            background = Background::kept;
        }
        if (background == Background::drawn) fill_rows(target_, rows);
        if (depth_ != nullptr) copy_depth(memory.band);
    }

    /// Finds out what each pixel shows.
    void see(const ObjectPass& pass, int number, BandMemory& memory) {
        raster::AttributeRecords& records = memory.shade.records;
        records.clear(pass.attributes.count);
        Walker walker(pass, *memory_.path.raster, memory.walks, memory.band, records);
        for (const raster::Bin& bin : pass.bins) {
            memory_.path.raster->draw_items(pass.polygons, lit_sides(bin.band(number), memory),
                                            memory.band, records, walker);
        }
    }

    /// Where only fronts are lit, they are seen from behind too.
    std::span<const raster::FaceItem> lit_sides(std::span<const raster::FaceItem> items,
                                                BandMemory& memory) const {
        if (settings_.sides == Sides::two) return items;
        memory.items.assign(items.begin(), items.end());
        for (raster::FaceItem& item : memory.items)
            item &= ~raster::back_flag;
        return memory.items;
    }

    /// Gives each pixel its light.
    void shade(const ObjectPass& pass, BandMemory& memory, Background background) {
        memory_.path.set_up_planes(pass, memory.shade.records);
        memory.shaded +=
            memory_.path.shade_band(pass, memory.band, memory.shade, target_, background);
    }

    void copy_depth(raster::VisibleBand& band) {
        for (int y = band.rows().y_begin; y < band.rows().y_end; ++y)
            std::copy_n(band.depth_row(y), band.width(), depth_->row(y).begin());
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
        for (BandMemory& band : memory_.bands) {
            counts.spans += band.band.counts().spans;
            counts.pixels_tested += band.band.counts().tested;
            counts.pixels_passed += band.band.counts().passed;
            counts.pixels_shaded += band.shaded;
        }
        return counts;
    }

    static std::size_t vertex_count(const ObjectPass& pass) { return pass.mesh().vertices.size(); }
    static std::size_t face_count(const ObjectPass& pass) { return pass.mesh().face_count(); }

    template <class Count, class Work>
    void for_each_piece(std::size_t size, Count count, Work&& work) {
        const std::vector<Piece> pieces = pieces_of(memory_.passes, size, count);
        memory_.workers.for_each(pieces.size(),
                                 [&](int worker, std::size_t i) { work(worker, pieces[i]); });
    }

    Memory& memory_;
    const Scene& scene_;
    const Settings& settings_;
    const Target& target_;
    raster::Plane<raster::Depth>* depth_;
    Frame frame_;
    raster::Bands bands_;
};

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
    const Target target = FloatTarget{&color, scene.background};
    return Picture(*memory_, scene, settings, target, depth).draw();
}

DrawReport Renderer::draw(const Scene& scene, const Settings& settings,
                          raster::Plane<raster::PackedPixel>& color, raster::Encoding encoding,
                          raster::Plane<raster::Depth>* depth) {
    const Target target =
        PackedTarget{&color, encoding, raster::packed_pixel(scene.background, encoding)};
    return Picture(*memory_, scene, settings, target, depth).draw();
}

}  // namespace scanlight::render
