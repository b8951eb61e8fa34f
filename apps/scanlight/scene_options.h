#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/scanlight/facet_options.h"
#include "apps/scanlight/parse.h"
#include "apps/scanlight/texture_option.h"
#include "mesh/build.h"
#include "raster/project.h"
#include "render/scene.h"

namespace CLI {
class App;
}

namespace scanlight::apps {

/// How a triangle or n-gon is interpolated: as it is, or cut into triangles first.
enum class Polygons { bilinear, triangulated };

/// Which polygon edges are drawn, beside the shading.
enum class Wireframe { none, all, hidden, over };

/// What the colours of a picture mean.
enum class Show { light, stencil, details, fresnel };

/// All that says what a picture shows, apart from the file it goes to. One table of options serves
/// `render`, `steps` and the figures.
struct SceneOptions {
    std::string input;
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
    std::vector<LightOption> lights;
    float falloff_k = 1.0f;
    glm::vec3 ambient{0.15f};
    std::string material;
    std::vector<TextureOption> textures;
    bool own_textures = true;  // those of the mesh's materials
    std::string environment;   // an image file; "": none
    shading::EnvironmentLayout environment_layout = shading::EnvironmentLayout::latitudes;
    bool environment_light = false;
    FacetOptions facets;
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

/// The options that a command line gives, such as "teapot --shading flat": one picture's source.
SceneOptions parse_scene(const std::string& command_line);

/// Adds the options that say what each polygon looks like to a subcommand; `options` is filled as
/// the command line is parsed, and must outlive `app`.
void add_scene_options(CLI::App& app, SceneOptions& options);

/// Adds what a picture shows beside its polygons: their edges, and what lies behind.
void add_canvas_options(CLI::App& app, SceneOptions& options);

}  // namespace scanlight::apps
