#include "apps/scanlight/scene_options.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "apps/scanlight/choice_option.h"
#include "apps/scanlight/facet_options.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scanlight/text_option.h"
#include "apps/scene/read_scene.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

/// What the command line says holds for all objects, whatever a scene file says of them.
template <class Forget>
void for_all_objects(CLI::Option* option, SceneOptions& o, Forget forget) {
    option->each([&o, forget](const std::string&) {
        for (ObjectOptions& object : o.objects)
            forget(object);
    });
}

void add_picture_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Picture");
    add_text(app, "-s,--size", "WxH", "picture size in pixels", [&o](const std::string& text) {
        o.size = parse_size(text);
    })->default_str(std::to_string(o.size.width) + "x" + std::to_string(o.size.height));
    for_all_objects(add_choice(app, "--shading", o.settings.shading,
                               "one intensity a polygon, intensities interpolated, or normals"),
                    o, [](ObjectOptions& object) { object.own.shading.reset(); });
    for_all_objects(
        add_choice(
            app, "--illumination", o.settings.illumination,
            "the illumination model: (R.V)^n for phong, (N.H)^n for blinn, and for hall, who adds\n"
            "light from behind; microfacets for cook-torrance"),
        o, [](ObjectOptions& object) { object.own.illumination.reset(); });
    for_all_objects(
        add_choice(app, "--interpolation", o.polygons,
                   "n-gons by the textbook's bilinear rule, or cut into triangles first"),
        o, [](ObjectOptions& object) { object.polygons.reset(); });
    for_all_objects(
        add_choice(
            app, "--perspective", o.settings.perspective,
            "attributes even over the object, or (affine) over the screen as in the textbook"),
        o, [](ObjectOptions& object) { object.own.perspective.reset(); });
    for_all_objects(add_choice(app, "--cull", o.settings.cull, "polygons to leave out"), o,
                    [](ObjectOptions& object) { object.own.cull.reset(); });
    for_all_objects(add_choice(app, "--sides", o.settings.sides,
                               "light the front only, or the side that is seen"),
                    o, [](ObjectOptions& object) { object.own.sides.reset(); });
    add_choice(app, "--distances", o.settings.distances,
               "eye and lights at their places, or at infinity as in the textbook");
}

/// An option of shadow maps: that it was given is kept.
CLI::Option* of_maps(CLI::Option* option, SceneOptions& o) {
    return option->type_name("N")->capture_default_str()->each(
        [&o, option](const std::string&) { o.shadow_map_option = option->get_name(); });
}

/// An odd number of cells, or what is wrong with it.
std::string check_filter(const std::string& text) {
    const double cells = parse_number(text, "shadow-pcf");
    for (const int odd : {1, 3, 5, 7, 9, 11, 13, 15}) {
        if (cells == odd) return "";
    }
    return "'" + text + "': expected an odd number from 1 to 15";
}

void add_shadow_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Shadows");
    auto& map = o.settings.shadow_map;
    add_choice(
        app, "--shadows", o.settings.shadows,
        "shadow volumes, counted to the surface (zpass) or behind it (zfail), from zero to show\n"
        "the classic mistake of an eye in a shadow; a z-buffer of the light's view (map); or the\n"
        "lit parts of polygons, clipped as polygons (polygons)");
    of_maps(app.add_option("--shadow-map-size", map.size,
                           "cells along each side of a shadow map; a point light has six maps")
                ->check(CLI::Range(32, 8192).description("from 32 to 8192")),
            o);
    of_maps(app.add_option(
                   "--shadow-bias", map.bias,
                   "how far, in cells of the map, a surface may lie behind its depth there and\n"
                   "still be lit; too little lets it shadow itself, too much moves shadows away")
                ->check(within(0.0, 1000.0)),
            o);
    of_maps(app.add_option("--shadow-pcf", map.filter,
                           "percentage-closer filter of N x N cells, odd; 1 is none")
                ->check(CLI::Validator(check_filter, "odd, from 1 to 15")),
            o);
}

/// The colours alone: what is said of facets and textures stays.
void set_colors(MaterialOptions& material, MaterialOptions colors) {
    colors.facets = material.facets;
    colors.textures = material.textures;
    material = std::move(colors);
}

void add_sample_option(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Picture");
    add_text(app, "--samples", "1|4|16",
             "samples a pixel, in a square grid, averaged in linear light, against jagged edges",
             [&o](const std::string& text) { o.settings.grid = parse_samples(text); })
        ->default_str("1");
}

void add_mesh_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Mesh and surface");
    for_all_objects(add_choice(app, "--normals", o.normals.weight,
                               "vertex normals: the faces' mean, weighted, or the file's"),
                    o, [](ObjectOptions& object) { object.normals.reset(); });
    for_all_objects(app.add_option("--crease", o.normals.crease_deg,
                                   "faces at a larger angle than this share no normal; 180 smooths "
                                   "all")
                        ->type_name("DEG")
                        ->check(within(0.0, 180.0))
                        ->capture_default_str(),
                    o, [](ObjectOptions& object) { object.crease_deg.reset(); });
    add_text(app, "--material", "\"kd=C ks=C n=N\"",
             "the surface, instead of the file's: ka, kd, ks, mirror, refract (colours), n "
             "(exponent), opacity\n"
             "(0 to 1), tf (the colour of light that comes through it), and for hall kdt, kt, nt,\n"
             "the same of light from behind; any of them",
             [&o](const std::string& text) { set_colors(o.material, parse_material(text)); });
    app.add_option_function<std::vector<std::string>>(
           "--texture",
           [&o](const std::vector<std::string>& texts) {
               for (const auto& text : texts) {
                   auto [slot, texture] = parse_texture(text);
                   add_texture(o, slot, std::move(texture));
               }
           },
           "what changes over the surface, repeatable, instead of the file's. SLOT: diffuse, "
           "specular,\n"
           "ambient, exponent, opacity, bump, normal. KIND: image:PATH, checker, stripes, "
           "gradient, waves, and in "
           "space wood,\n"
           "marble, cubes. Then any of mapping=uv|planar|cylindrical|chapter-cylinder|spherical,\n"
           "axis=x|y|z, scale=N, repeat=U[,V], offset=U[,V], count=N, bend=N, low=COLOUR,\n"
           "high=COLOUR, filter=nearest|bilinear|trilinear, wrap=repeat|clamp|mirror, height=N")
        ->type_name("\"SLOT=KIND …\"")
        ->allow_extra_args(false);
    app.add_flag("--no-textures{false}", o.own_textures,
                 "leave out the textures that the mesh's own materials name");
}

/// What none of the chosen models knows is refused.
void check_models(const SceneOptions& o, const std::vector<ModelOption>& options,
                  const CLI::Option* material) {
    using enum shading::Illumination;
    const IlluminationModels chosen = models_in(o);
    const bool bends_light = o.material.refracted.has_value();
    for (const ModelOption& given : options) {
        if (bends_light && given.option->get_name() == "--ior") continue;
        if (given.option->count() > 0)
            require_model(given.option->get_name(), chosen, given.models);
    }
    if (o.show == Show::fresnel) require_model("--show fresnel", chosen, {cook_torrance});
    if (material->count() > 0 && !shading::is_opaque(with({}, o.material).transmission))
        require_model("material kdt and kt", chosen, {hall});
}

void add_camera_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Camera");
    CLI::Option* view =
        add_text(app, "--view", "AZ,EL", "look from this azimuth and elevation, in degrees",
                 [&o](const std::string& text) { look_from(o, parse_view(text)); })
            ->default_str("30,20");
    CLI::Option* fov =
        add_text(app, "--fov", "DEG", "vertical field of view, in degrees",
                 [&o](const std::string& text) { set_field_of_view(o, parse_number(text, "fov")); })
            ->check(within(1.0, 170.0))
            ->default_str("30");
    app.add_option("--lens", o.lens_mm, "focal length for a frame 24 mm high, instead of --fov")
        ->type_name("MM")
        ->check(within(1.0, 5000.0))
        ->excludes(fov);
    add_choice(app, "--projection", o.projection, "lines of sight through the eye, or parallel");
    app.add_option("--zoom", o.zoom, "enlarge the picture about its centre")
        ->check(within(0.001, 1000.0))
        ->capture_default_str();
    CLI::Option* eye =
        add_text(app, "--eye", "X,Y,Z", "the camera's place in the world, instead of --view",
                 [&o](const std::string& text) {
                     o.eye = parse_point(text, "eye");
                     o.camera_keys.clear();
                 })
            ->excludes(view);
    add_text(app, "--target", "X,Y,Z", "what --eye looks at; the middle of the mesh if not given",
             [&o](const std::string& text) { o.target = parse_point(text, "target"); })
        ->needs(eye);
}

void add_light_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Light");
    app.add_option_function<std::vector<std::string>>(
           "--light",
           [&o](const std::vector<std::string>& texts) {
               o.lights.clear();  // those of a scene file
               for (const auto& text : texts)
                   o.lights.push_back(parse_light(text));
           },
           "a light, repeatable; one from the upper left if not given. X,Y,Z is its direction as\n"
           "the camera sees it (right, up, towards the viewer), with world: a direction in the\n"
           "world, with point: a place in it, which may have a fall-off: constant, inverse,\n"
           "inverse-square or inverse-plus-k")
        ->type_name("[world:|point:]X,Y,Z[,#RRGGBB][,FALLOFF]")
        ->allow_extra_args(false);
    app.add_option("--falloff-k", o.falloff_k, "k of inverse-plus-k, in world units")
        ->check(within(1e-6, 1e6))
        ->capture_default_str()
        ->each([&o](const std::string&) {
            for (LightOption& light : o.lights)
                light.falloff_k.reset();
        });
    for_all_objects(
        app.add_option("--gouraud71-k", o.settings.gouraud71_k, "k of gouraud71, in world units")
            ->check(within(1e-6, 1e6))
            ->capture_default_str(),
        o, [](ObjectOptions& object) { object.own.gouraud71_k.reset(); });
    app.add_option("--environment", o.environment.image,
                   "a picture of all directions, or the built-in room, seen behind everything;\n"
                   "surfaces with a mirror= colour reflect it in Phong shading")
        ->type_name("FILE|room")
        ->each([&o](const std::string&) { o.environment.stated = {}; });
    add_choice(app, "--environment-layout", o.environment.layout,
               "longitude and latitude with y up, a mirror ball seen from the camera, or the six\n"
               "sides of a cube: in a row or column (+x -x +y -y ahead behind), or a cross");
    app.add_flag("--environment-light", o.environment.lights,
                 "the environment lights matt surfaces too, in Phong shading");
    add_text(app, "--environment-from", "X,Y,Z",
             "mirror what is seen from here, drawn on the six sides of a cube: all things that do\n"
             "not mirror or refract, before the environment",
             [&o](const std::string& text) {
                 o.environment.seen_from = parse_point(text, "environment-from");
             });
    add_text(app, "--ambient", "COLOUR", "the ambient light I_a: #rrggbb, or linear grey or r,g,b",
             [&o](const std::string& text) { o.ambient = parse_color(text); })
        ->default_str("0.15");
}

}  // namespace

SceneOptions parse_scene(const std::string& command_line) {
    SceneOptions options;
    CLI::App app;
    add_scene_options(app, options);
    add_canvas_options(app, options);
    app.parse(command_line);
    check_shadows(options);
    return options;
}

void add_scene_options(CLI::App& app, SceneOptions& options) {
    add_text(app, "input", "IN",
             "scene file (.toml), mesh file (OBJ, PLY, OFF, STL), - or a built-in shape",
             [&options](const std::string& input) { set_input(options, input); })
        ->required();
    add_picture_options(app, options);
    add_sample_option(app, options);
    add_shadow_options(app, options);
    add_mesh_options(app, options);
    const auto of_models = add_facet_options(app, options.material.facets);
    const CLI::Option* material = app.get_option("--material");
    app.parse_complete_callback(
        [&options, of_models, material] { check_models(options, of_models, material); });
    add_camera_options(app, options);
    add_light_options(app, options);
}

void add_canvas_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Picture");
    add_text(app, "--background", "COLOUR|none",
             "what lies behind, light grey if not given; none is transparent, in a PNG",
             [&o](const std::string& text) {
                 if (text == "none") {
                     o.background.reset();
                 } else {
                     o.background = parse_color(text);
                 }
             });
    add_choice(app, "--show", o.show,
               "the light; in how many shadow volumes each surface lies, as a heat map; over the\n"
               "light the outlines of lit parts (--shadows polygons), a colour a light; or what a\n"
               "smooth surface would mirror of the light, by Fresnel's equations");
    app.add_flag("--floor", o.floor, "a white floor beneath the mesh, four times as wide");
    app.add_flag(
        "--wireframe{all}", o.wireframe_word,
        "draw edges: =all (or no word), =hidden (without the hidden ones), =over (over the\n"
        "shading)");
}

}  // namespace scanlight::apps
