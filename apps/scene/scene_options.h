#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "apps/scene/parse.h"
#include "apps/scene/stated.h"
#include "mesh/build.h"
#include "raster/project.h"
#include "render/scene.h"
#include "shading/environment.h"

namespace scanlight::apps {

/// How a triangle or n-gon is interpolated: as it is, or cut into triangles first.
enum class Polygons { bilinear, triangulated };

/// Which polygon edges are drawn, beside the shading.
enum class Wireframe { none, all, hidden, over };

/// What the colours of a picture mean.
enum class Show { light, stencil, details, fresnel };

/// A rotation about an axis through the origin, counter-clockwise seen from its tip.
struct Turn {
    glm::dvec3 axis{0.0, 1.0, 0.0};
    double angle_deg = 0.0;
};

/// Where an object stands: scaled, then turned, the first turn first, then moved; or by a matrix.
struct Placement {
    glm::dvec3 scale{1.0};
    std::vector<Turn> turns;
    glm::dvec3 translate{0.0};
    std::optional<glm::dmat4> matrix;
};

/// A mesh in the world. What is not given is as for the whole picture.
struct ObjectOptions {
    std::string input;     // mesh file, "-" for standard input, or a built-in shape
    std::string material;  // by its name, over the mesh's own; empty: none
    SlotNames textures;    // over the material's
    Placement placement;
    std::optional<Polygons> polygons;
    std::optional<mesh::NormalWeight> normals;
    std::optional<float> crease_deg;
    render::OwnSettings own;
    Stated stated;
};

/// The camera at a moment of a turntable.
struct CameraKey {
    double at = 0.0;  // 0 the first frame, 1 one past the last
    std::optional<render::ViewAngles> view;
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> target;
    std::optional<double> zoom;
    std::optional<double> fov_deg;
    Stated stated;
};

/// What is around everything.
struct EnvironmentOptions {
    std::string image;  // a file, or "room"; "": none
    shading::EnvironmentLayout layout = shading::EnvironmentLayout::latitudes;
    bool lights = false;                  // matt surfaces too
    std::optional<glm::dvec3> seen_from;  // what is mirrored; none: the image
    Stated stated;
};

/// All that says what a picture shows, apart from the file it goes to: what a command line or a
/// scene file describes. `keys.h` has what a file calls each part of it.
struct SceneOptions {
    std::string input;  // what the person named: a scene file, or the input of the one object
    raster::Viewport size{640, 480};
    render::Settings settings;
    std::string shadow_map_option;  // one that was given, such as "--shadow-bias"
    std::string wireframe_word;     // "", all, hidden or over
    Show show = Show::light;
    Polygons polygons = Polygons::bilinear;
    mesh::NormalRule normals;
    render::ViewAngles view;
    double fov_deg = 30.0;
    double lens_mm = 0.0;  // 0: by fov_deg
    render::Projection projection = render::Projection::perspective;
    double zoom = 1.0;
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> target;
    std::optional<glm::dvec3> up;
    std::vector<LightOption> lights;
    float falloff_k = 1.0f;
    glm::vec3 ambient{0.15f};
    MaterialOptions material;  // over those of all objects
    std::vector<MaterialOptions> materials;
    std::vector<TextureOption> textures;
    bool own_textures = true;  // those of the meshes' materials
    EnvironmentOptions environment;
    std::vector<ObjectOptions> objects;
    std::vector<CameraKey> camera_keys;  // of a turntable
    bool floor = false;
    std::optional<glm::vec3> background{glm::vec3(0.807f, 0.831f, 0.871f)};  // none: transparent
};

/// `all`: the edges alone; `hidden`: alone, without those behind polygons; `over`: over the
/// shading. Throws UsageError for another word.
Wireframe wireframe_of(const SceneOptions& options);

/// Throws UsageError for options that ask for something of one way to find shadows and name
/// another.
void check_shadows(const SceneOptions& options);

/// The method by which shadow volumes are counted: z-fail where the options name none. Throws
/// UsageError where they name one without volumes; `what` asks for them, such as "--show stencil".
render::Shadows volumes_for(const std::string& what, const SceneOptions& options);

/// Puts a texture on all objects, whatever was on them.
void add_texture(SceneOptions& options, TextureSlot slot, TextureOption texture);

/// The lights of the picture: those that are given, or one from the upper left.
std::vector<LightOption> lights_in(const SceneOptions& options);

/// The illumination models by which objects are drawn.
std::vector<shading::Illumination> models_in(const SceneOptions& options);

/// Throws UsageError for a picture with more samples than can be drawn.
void check_size(const SceneOptions& options);

/// The camera looks from the side that is named, whatever was said before, and stays there.
void look_from(SceneOptions& options, const render::ViewAngles& view);

/// The camera's angle of view, whatever was said before.
void set_field_of_view(SceneOptions& options, double fov_deg);

}  // namespace scanlight::apps
