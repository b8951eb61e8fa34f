#include "apps/scene/picture_keys.h"

#include "apps/scene/object_keys.h"

namespace scanlight::apps {

// ---- [camera]

KeyTable<SceneOptions> camera_keys() {
    using O = SceneOptions;
    const auto has_view = [](const O& o) {
        return !o.eye && (o.view.azimuth_deg != O{}.view.azimuth_deg ||
                          o.view.elevation_deg != O{}.view.elevation_deg);
    };
    const auto has_lens = [](const O& o) { return o.lens_mm > 0.0; };
    return {
        {chosen_key<O>(
             "view", view_angles(), look_from, has_view, [](auto& o) { return o.view; }, "[30, 20]",
             "Looks from this side, as far away as shows all. Azimuth 0 looks from +z, 90 from "
             "+x."),
         optional_key<O>(
             "eye", point(), [](auto& o) -> auto& { return o.eye; }, "by `view`",
             "The camera's place in the world."),
         optional_key<O>(
             "target", point(), [](auto& o) -> auto& { return o.target; },
             "the middle of the objects", "What `eye` looks at."),
         optional_key<O>(
             "up", direction(), [](auto& o) -> auto& { return o.up; }, "[0, 1, 0]",
             "What is upward in the picture."),
         chosen_key<O>(
             "fov_deg", number(1.0, 170.0), set_field_of_view,
             [](const O& o) { return o.lens_mm == 0.0 && o.fov_deg != O{}.fov_deg; },
             [](auto& o) { return o.fov_deg; }, "30", "Vertical field of view, in degrees."),
         chosen_key<O>(
             "lens_mm", number(1.0, 5000.0), [](O& o, double mm) { o.lens_mm = mm; }, has_lens,
             [](auto& o) { return o.lens_mm; }, "by `fov_deg`",
             "Focal length for a frame 24 mm high."),
         key<O>(
             "projection", word<render::Projection>(),
             [](auto& o) -> auto& { return o.projection; },
             "Lines of sight through the eye, or parallel."),
         key<O>(
             "zoom", number(0.001, 1000.0), [](auto& o) -> auto& { return o.zoom; },
             "Enlarges the picture about its centre.")},
        {{}, {{"view", "eye"}, {"fov_deg", "lens_mm"}}, {{"target", "eye"}}}};
}

// ---- [[camera.key]]

KeyTable<CameraKey> camera_key_keys() {
    using O = CameraKey;
    return {
        {chosen_key<O>(
             "at", number(0.0, 1.0), [](O& o, double at) { o.at = at; },
             [](const O&) { return true; }, [](auto& o) { return o.at; }, "0",
             "When: 0 is the first frame, 1 one past the last."),
         optional_key<O>(
             "view", view_angles(), [](auto& o) -> auto& { return o.view; }, "",
             "Looks from this side at the middle of the objects, at a distance that shows all."),
         optional_key<O>(
             "eye", point(), [](auto& o) -> auto& { return o.eye; }, "",
             "The camera's place in the world."),
         optional_key<O>(
             "target", point(), [](auto& o) -> auto& { return o.target; }, "as in `[camera]`",
             "What `eye` looks at."),
         optional_key<O>(
             "zoom", number(0.001, 1000.0), [](auto& o) -> auto& { return o.zoom; },
             "as in `[camera]`", "Enlarges the picture about its centre."),
         optional_key<O>(
             "fov_deg", number(1.0, 170.0), [](auto& o) -> auto& { return o.fov_deg; },
             "as in `[camera]`", "Vertical field of view, in degrees.")},
        {{{"view", "eye"}}, {{"view", "eye"}}, {{"target", "eye"}}}};
}

// ---- [render]

KeyTable<SceneOptions> render_keys() {
    using O = SceneOptions;
    return {
        {key<O>(
             "size", picture_size(), [](auto& o) -> auto& { return o.size; },
             "Picture size in pixels."),
         key<O>(
             "samples", samples(), [](auto& o) -> auto& { return o.settings.grid; },
             "Samples a pixel, in a square grid, averaged in linear light, against jagged edges."),
         key<O>(
             "shading", word<render::Shading>(),
             [](auto& o) -> auto& { return o.settings.shading; },
             "One intensity a polygon, intensities interpolated, or normals."),
         key<O>(
             "illumination", word<shading::Illumination>(),
             [](auto& o) -> auto& { return o.settings.illumination; },
             "The illumination model: (R.V)^n for phong, (N.H)^n for blinn and for hall, who adds "
             "light from behind; microfacets for cook-torrance."),
         key<O>(
             "gouraud71_k", float_number(1e-6, 1e6),
             [](auto& o) -> auto& { return o.settings.gouraud71_k; },
             "k of gouraud71, in world units."),
         key<O>(
             "interpolation", word<Polygons>(), [](auto& o) -> auto& { return o.polygons; },
             "N-gons by the textbook's bilinear rule, or cut into triangles first."),
         key<O>(
             "perspective", word<render::Perspective>(),
             [](auto& o) -> auto& { return o.settings.perspective; },
             "Attributes even over the object, or (affine) over the screen."),
         key<O>(
             "cull", word<render::Cull>(), [](auto& o) -> auto& { return o.settings.cull; },
             "Polygons to leave out, by the way they face."),
         key<O>(
             "sides", word<render::Sides>(), [](auto& o) -> auto& { return o.settings.sides; },
             "Light the front only, or the side that is seen."),
         key<O>(
             "distances", word<render::Distances>(),
             [](auto& o) -> auto& { return o.settings.distances; },
             "Eye and lights at their places, or at infinity."),
         key<O>(
             "shadows", word<render::Shadows>(),
             [](auto& o) -> auto& { return o.settings.shadows; },
             "How shadows are found: by volumes, counted from the eye or from behind; by a "
             "z-buffer "
             "of the light's view; or by polygons clipped by polygons."),
         key<O>(
             "shadow_map_size", whole_number(32, 8192),
             [](auto& o) -> auto& { return o.settings.shadow_map.size; },
             "Cells along each side of a shadow map."),
         key<O>(
             "shadow_bias", number(0.0, 1000.0),
             [](auto& o) -> auto& { return o.settings.shadow_map.bias; },
             "How far, in cells of the map, a surface may lie behind its depth there and be lit."),
         key<O>(
             "shadow_pcf", odd_number(15),
             [](auto& o) -> auto& { return o.settings.shadow_map.filter; },
             "Percentage-closer filter of so many cells each way."),
         key<O>(
             "own_textures", boolean(), [](auto& o) -> auto& { return o.own_textures; },
             "Whether the textures that the meshes' own materials name are drawn."),
         key<O>(
             "normals", word<mesh::NormalWeight>(),
             [](auto& o) -> auto& { return o.normals.weight; },
             "Vertex normals: the faces' mean, weighted, or the file's."),
         key<O>(
             "crease_deg", float_number(0.0, 180.0),
             [](auto& o) -> auto& { return o.normals.crease_deg; },
             "Faces at a larger angle than this share no normal; 180 smooths all."),
         key<O>(
             "ambient", color(), [](auto& o) -> auto& { return o.ambient; },
             "The ambient light I_a."),
         key<O>(
             "falloff_k", float_number(1e-6, 1e6), [](auto& o) -> auto& { return o.falloff_k; },
             "k of the lights' fall-off inverse-plus-k, in world units."),
         key<O>(
             "background", color_or_none(), [](auto& o) -> auto& { return o.background; },
             "What lies behind; none is transparent, in a PNG."),
         key<O>(
             "floor", boolean(), [](auto& o) -> auto& { return o.floor; },
             "A white floor beneath the objects, four times as wide."),
         key<O>(
             "show", word<Show>(), [](auto& o) -> auto& { return o.show; },
             "The light; in how many shadow volumes each surface lies, as a heat map; the light "
             "and "
             "the outlines of its polygons' lit parts; or what smooth surfaces would mirror."),
         chosen_key<O>(
             "wireframe", one_of({"all", "hidden", "over"}),
             [](O& o, const std::string& which) { o.wireframe_word = which; },
             [](const O& o) { return !o.wireframe_word.empty(); },
             [](auto& o) { return o.wireframe_word; }, "none",
             "Draws edges alone, alone without the hidden ones, or over the shading.")},
        {}};
}

// ---- [[light]]

KeyTable<LightOption> light_keys() {
    using O = LightOption;
    const auto is_point = [](const O& o) { return o.frame == LightFrame::point; };
    const auto set_frame = [](O& o, const std::string& frame) {
        o.frame = frame == "world" ? LightFrame::world : LightFrame::camera;
    };
    const auto set_position = [](O& o, const glm::dvec3& position) {
        o.place = position;
        o.frame = LightFrame::point;
    };
    return {{chosen_key<O>(
                 "direction", direction(), [](O& o, const glm::dvec3& v) { o.place = v; },
                 [=](const O& o) { return !is_point(o); }, [](auto& o) { return o.place; }, "",
                 "Towards a light at infinity."),
             chosen_key<O>(
                 "frame", one_of({"camera", "world"}), set_frame,
                 [](const O& o) { return o.frame == LightFrame::world; },
                 [](auto&) { return std::string("world"); }, "\"camera\"",
                 "Whose directions: right, up and towards the viewer, or the world's."),
             chosen_key<O>(
                 "position", point(), set_position, is_point, [](auto& o) { return o.place; }, "",
                 "The place of a lamp in the world."),
             key<O>(
                 "color", color(), [](auto& o) -> auto& { return o.color; },
                 "Its intensity I_p; may be above 1."),
             key<O>(
                 "falloff", word<shading::Falloff>(), [](auto& o) -> auto& { return o.falloff; },
                 "How it weakens with the distance r: 1, 1/r, 1/r^2 or 1/(r + k)."),
             optional_key<O>(
                 "falloff_k", float_number(1e-6, 1e6), [](auto& o) -> auto& { return o.falloff_k; },
                 as_the_picture, "k of inverse-plus-k, in world units.")},
            {{{"direction", "position"}},
             {{"direction", "position"}, {"frame", "position"}},
             {{"falloff", "position"}, {"falloff_k", "falloff"}}}};
}

// ---- [environment]

namespace {

constexpr const char* built_in_room = "room";

/// A file of that name is not meant to be the built-in one.
std::string as_file(const std::string& path) {
    return path == built_in_room ? "./" + path : path;
}

}  // namespace

KeyTable<EnvironmentOptions> environment_keys() {
    using O = EnvironmentOptions;
    const auto is_built_in = [](const O& o) { return o.image == built_in_room; };
    const auto get_image = [](auto& o) { return o.image; };
    return {
        {chosen_key<O>(
             "image", image_path(), [](O& o, const std::string& path) { o.image = as_file(path); },
             [=](const O& o) { return !o.image.empty() && !is_built_in(o); }, get_image, "none",
             "A picture of all directions: seen behind everything, and mirrored."),
         chosen_key<O>(
             "built_in", one_of({built_in_room}),
             [](O& o, const std::string& name) { o.image = name; }, is_built_in, get_image, "none",
             "The built-in one, in the image's place."),
         key<O>(
             "layout", word<shading::EnvironmentLayout>(),
             [](auto& o) -> auto& { return o.layout; },
             "Longitude and latitude with y up, a mirror ball seen from the camera, or the six "
             "sides of a cube in a row, a column or a cross, with -z in its middle."),
         key<O>(
             "light", boolean(), [](auto& o) -> auto& { return o.lights; },
             "Whether it lights matt surfaces too, in Phong shading."),
         optional_key<O>(
             "seen_from", point(), [](auto& o) -> auto& { return o.seen_from; }, "none",
             "What is mirrored is drawn by the rasterizer, as seen from here: all things that "
             "mirror and refract nothing, before the picture of all directions.")},
        {{}, {{"image", "built_in"}}}};
}

}  // namespace scanlight::apps
