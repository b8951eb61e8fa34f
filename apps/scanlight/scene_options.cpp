#include "apps/scanlight/scene_options.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "apps/scanlight/choice_option.h"
#include "apps/scanlight/help_heading.h"
#include "apps/scanlight/text_option.h"
#include "apps/scanlight/usage_error.h"

namespace scanlight::apps {

namespace {

void add_picture_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Picture");
    add_text(app, "-s,--size", "WxH", "picture size in pixels", [&o](const std::string& text) {
        o.size = parse_size(text);
    })->default_str(std::to_string(o.size.width) + "x" + std::to_string(o.size.height));
    add_choice(app, "--shading", o.settings.shading,
               "one intensity a polygon, intensities interpolated, or normals");
    add_choice(
        app, "--illumination", o.settings.illumination,
        "the illumination model: (R.V)^n for phong, (N.H)^n for blinn, and for hall, who adds\n"
        "light from behind; microfacets for cook-torrance");
    add_choice(app, "--interpolation", o.polygons,
               "n-gons by the textbook's bilinear rule, or cut into triangles first");
    add_choice(app, "--perspective", o.settings.perspective,
               "attributes even over the object, or (affine) over the screen as in the textbook");
    add_choice(app, "--cull", o.settings.cull, "polygons to leave out");
    add_choice(app, "--sides", o.settings.sides, "light the front only, or the side that is seen");
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

void add_mesh_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Mesh and surface");
    add_choice(app, "--normals", o.normals.weight,
               "vertex normals: the faces' mean, weighted, or the file's");
    app.add_option("--crease", o.normals.crease_deg,
                   "faces at a larger angle than this share no normal; 180 smooths all")
        ->type_name("DEG")
        ->check(within(0.0, 180.0))
        ->capture_default_str();
    add_text(
        app, "--material", "\"kd=C ks=C n=N\"",
        "the surface, instead of the file's: ka, kd, ks, mirror (colours), n (exponent), opacity\n"
        "(0 to 1), and for hall kdt, kt, nt, the same of light from behind; any of them",
        [&o](const std::string& text) {
            parse_material(text, {});  // what is wrong with it is said at once
            o.material = text;
        });
    app.add_option_function<std::vector<std::string>>(
           "--texture",
           [&o](const std::vector<std::string>& texts) {
               for (const auto& text : texts)
                   o.textures.push_back(parse_texture(text));
           },
           "what changes over the surface, repeatable, instead of the file's. SLOT: diffuse, "
           "specular, ambient, "
           "exponent,\n"
           "exponent, bump, normal. KIND: image:PATH, checker, stripes, gradient, waves, and in "
           "space wood,\n"
           "marble, cubes. Then any of mapping=uv|planar|cylindrical|chapter-cylinder|spherical,\n"
           "axis=x|y|z, scale=N, repeat=U[,V], offset=U[,V], count=N, bend=N, low=COLOUR,\n"
           "high=COLOUR, filter=nearest|bilinear|trilinear, wrap=repeat|clamp|mirror, height=N")
        ->type_name("\"SLOT=KIND …\"")
        ->allow_extra_args(false);
    app.add_flag("--no-textures{false}", o.own_textures,
                 "leave out the textures that the mesh's own materials name");
}

/// What the chosen model does not know is refused.
void check_model(const SceneOptions& o, const std::vector<ModelOption>& options) {
    using enum shading::Illumination;
    const auto chosen = o.settings.illumination;
    for (const ModelOption& given : options) {
        if (given.option->count() > 0)
            require_model(given.option->get_name(), chosen, given.models);
    }
    if (o.show == Show::fresnel) require_model("--show fresnel", chosen, {cook_torrance});
    if (!shading::is_opaque(parse_material(o.material, {}).transmission))
        require_model("material kdt and kt", chosen, {hall});
}

void add_camera_options(CLI::App& app, SceneOptions& o) {
    const HelpHeading heading(app, "Camera");
    CLI::Option* view =
        add_text(app, "--view", "AZ,EL", "look from this azimuth and elevation, in degrees",
                 [&o](const std::string& text) { o.view = parse_view(text); })
            ->default_str("30,20");
    CLI::Option* fov = app.add_option("--fov", o.fov_deg, "vertical field of view, in degrees")
                           ->type_name("DEG")
                           ->check(within(1.0, 170.0))
                           ->capture_default_str();
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
                 [&o](const std::string& text) { o.eye = parse_point(text, "eye"); })
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
        ->capture_default_str();
    app.add_option("--gouraud71-k", o.settings.gouraud71_k, "k of gouraud71, in world units")
        ->check(within(1e-6, 1e6))
        ->capture_default_str();
    app.add_option("--environment", o.environment,
                   "a picture of all directions, or the built-in room, seen behind everything;\n"
                   "surfaces with a mirror= colour reflect it in Phong shading")
        ->type_name("FILE|room");
    add_choice(app, "--environment-layout", o.environment_layout,
               "longitude and latitude with y up, or a mirror ball seen from the camera");
    app.add_flag("--environment-light", o.environment_light,
                 "the environment lights matt surfaces too, in Phong shading");
    add_text(app, "--ambient", "COLOUR", "the ambient light I_a: #rrggbb, or linear grey or r,g,b",
             [&o](const std::string& text) { o.ambient = parse_color(text); })
        ->default_str("0.15");
}

}  // namespace

Wireframe wireframe_of(const SceneOptions& options) {
    const std::string& word = options.wireframe_word;
    if (word.empty()) return Wireframe::none;
    if (word == "all") return Wireframe::all;
    if (word == "hidden") return Wireframe::hidden;
    if (word == "over") return Wireframe::over;
    throw UsageError("wireframe '" + word + "': expected all, hidden or over");
}

void check_shadows(const SceneOptions& options) {
    const render::Shadows method = options.settings.shadows;
    if (!options.shadow_map_option.empty() && method != render::Shadows::map)
        throw UsageError(options.shadow_map_option + " is for --shadows map");
    if (options.show == Show::stencil) volumes_for("--show stencil", options);
    if (options.show == Show::details && method != render::Shadows::polygons)
        throw UsageError("--show details is for --shadows polygons");
}

render::Shadows volumes_for(const std::string& what, const SceneOptions& options) {
    const render::Shadows method = options.settings.shadows;
    if (method == render::Shadows::none) return render::Shadows::zfail;
    if (render::counts_volumes(method)) return method;
    throw UsageError(what + " counts shadow volumes, of which --shadows " + word_of(method) +
                     " has none; zpass and zfail have");
}

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
    app.add_option("input", options.input, "mesh file (OBJ, PLY, OFF, STL), - or a built-in shape")
        ->required()
        ->type_name("IN");
    add_picture_options(app, options);
    add_shadow_options(app, options);
    add_mesh_options(app, options);
    const auto of_models = add_facet_options(app, options.facets);
    app.parse_complete_callback([&options, of_models] { check_model(options, of_models); });
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
