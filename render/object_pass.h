#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "raster/attributes.h"
#include "raster/bins.h"
#include "raster/packed.h"
#include "raster/polygon_streams.h"
#include "render/frame.h"
#include "render/scene.h"
#include "render/shadow_sides.h"
#include "render/textured.h"
#include "render/vertex_streams.h"

namespace scanlight::render {

/// The faces of one object among those of all: their items count on from object to object.
struct FaceRange {
    std::int32_t first = 0;
    std::int32_t count = 0;

    static std::int32_t number_of(std::int32_t item) {
        return static_cast<std::int32_t>(static_cast<raster::FaceItem>(item) & raster::face_mask);
    }
    bool holds(std::int32_t item) const {
        const std::int32_t number = number_of(item);
        return number >= first && number - first < count;
    }
    /// Its place in the object's mesh.
    std::size_t face(std::int32_t item) const {
        return static_cast<std::size_t>(number_of(item) - first);
    }
};

/// One object on its way through the fast path: what its stages hand on, as plain arrays. Kept from
/// one picture to the next for its memory.
struct ObjectPass {
    const Object* object = nullptr;
    const Frame* frame = nullptr;
    Settings settings;  // its own
    FaceRange faces;
    Placing placing;
    VertexStreams vertices;
    /// Gouraud: intensities of the vertices from the front and, if lit, from the back; and the
    /// power of two by which they are divided when they are interpolated.
    VectorStreams front, back;
    float unit = 1.0f;
    std::vector<std::int32_t> vertex_material;  // empty if there is one material only
    TexturedAttributes textured;                // Phong shading of a textured object:
    std::vector<PlacedTextures> textures;       // of each material; empty if there are none
    float uv_unit = 1.0f;                       // by which (u, v) are divided
    shading::SiteNeeds needs;
    bool needs_point = true;  // in world space, where a pixel is lit
    FaceMatrices face_matrices;
    // Of each face, where that pays, else empty:
    std::vector<FaceUvs<float>> face_uvs;
    std::vector<std::int32_t> is_magnified;  // 1 where texels are sure to cover pixels, else 0
    raster::PolygonStreams polygons;
    raster::Attributes attributes;
    std::vector<raster::Bin> bins;                          // by stretches of faces
    std::vector<ShadowSides> sides;                         // of each light that casts shadows
    std::optional<mesh::SilhouetteFinder> own_silhouettes;  // where the object brings none

    /// Takes over an object of a picture with these settings, of which nothing is worked out yet;
    /// `first_face` is how many faces the objects before it have.
    void begin(const Object&, std::size_t first_face, const Frame&, const Settings&);
    void begin_textures();
    /// Makes room for the shadows of so many lights.
    void begin_shadows(std::size_t lights);
    /// Makes room for the light of the vertices.
    void begin_vertex_light();
    /// The vertices are placed and lit: says what is to be interpolated.
    void end_vertices();

    const mesh::Mesh& mesh() const { return *object->mesh; }
    const mesh::SilhouetteFinder& silhouettes() const {
        return object->silhouettes != nullptr ? *object->silhouettes : *own_silhouettes;
    }
    std::size_t bytes() const;
};

/// Where the pixels of a picture go: floats, or bytes in an encoding.
struct FloatTarget {
    raster::Plane<raster::Rgba>* plane;
    raster::Rgba background;
    int first_row = 0;  // of the picture, that the plane has

    std::span<raster::Rgba> row(int y) const { return plane->row(y - first_row); }
};
struct PackedTarget {
    raster::Plane<raster::PackedPixel>* plane;
    raster::Encoding encoding;
    raster::PackedPixel background;

    std::span<raster::PackedPixel> row(int y) const { return plane->row(y); }
};

using Target = std::variant<FloatTarget, PackedTarget>;

inline raster::Viewport size_of(const Target& target) {
    return std::visit(
        [](const auto& t) {
            return raster::Viewport{t.plane->width(), t.plane->height()};
        },
        target);
}

/// Stores a row of colours as the target takes them.
void store_colors(std::span<const raster::Rgba> colors, int y, const Target& target);

/// Whether what shows nothing is left as it is, or becomes background.
enum class Background { kept, drawn };

/// The encoding in which pixels keep their colour, where each gets its light as soon as a surface
/// is seen there. None where light waits until the nearest surface is known: where it is dear, and
/// where a colour is more than one number to keep.
std::optional<raster::Encoding> light_at_once(std::span<const ObjectPass> passes,
                                              const Target& target);

}  // namespace scanlight::render
