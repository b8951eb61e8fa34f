#include "apps/scene/keys.h"

#include "apps/scene/model.h"
#include "apps/scene/toml_number.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

namespace {

constexpr std::size_t most_camera_keys = 1000;
constexpr std::size_t most_lights = 1000;
constexpr std::size_t most_objects = 10000;
constexpr std::size_t most_materials = 10000;
constexpr std::size_t most_textures = 10000;

const std::string as_the_picture = "as in `[render]`";

// ---- sections

template <class Owner>
std::vector<KeyInfo> infos_of(const KeyTable<Owner>& table) {
    std::vector<KeyInfo> infos;
    for (const Key<Owner>& key : table.keys)
        infos.push_back(key.info);
    return infos;
}

/// A table of which there is one, for a part of the options.
template <class Owner, class Access>
Section one(const std::string& name, const std::string& meaning, const KeyTable<Owner>& table,
            Access access) {
    const auto read = [=](const Table& values, const Where& where, SceneOptions& options) {
        read_keys(table, values, where, access(options));
    };
    const auto write = [=](const SceneOptions& options, const std::filesystem::path& folder) {
        const std::string lines = write_keys(table, access(options), folder);
        return lines.empty() ? std::vector<std::string>{} : std::vector{lines};
    };
    return {name, meaning, 1, infos_of(table), table.rules, read, write};
}

/// A table of which there may be many, each one more of a list of the options.
template <class Owner>
Section many(const std::string& name, const std::string& meaning, std::size_t most,
             const KeyTable<Owner>& table, std::vector<Owner> SceneOptions::*list) {
    const auto read = [=](const Table& values, const Where& where, SceneOptions& options) {
        if ((options.*list).size() >= most)
            refuse_at(where.file, where.place,
                      "more than " + std::to_string(most) + " of " + where.table);
        read_keys(table, values, where, (options.*list).emplace_back());
    };
    const auto write = [=](const SceneOptions& options, const std::filesystem::path& folder) {
        std::vector<std::string> tables;
        for (const Owner& owner : options.*list)
            tables.push_back(write_keys(table, owner, folder));
        return tables;
    };
    return {name, meaning, most, infos_of(table), table.rules, read, write};
}

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

constexpr const char* built_in_room = "room";

/// A file of that name is not meant to be the built-in one.
std::string as_file(const std::string& path) {
    return path == built_in_room ? "./" + path : path;
}

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
             "Longitude and latitude with y up, or a mirror ball seen from the camera."),
         key<O>(
             "light", boolean(), [](auto& o) -> auto& { return o.lights; },
             "Whether it lights matt surfaces too, in Phong shading."),
         optional_key<O>(
             "seen_from", point(), [](auto& o) -> auto& { return o.seen_from; }, "none",
             "What is mirrored is drawn by the rasterizer, as seen from here: all things that "
             "mirror "
             "and refract nothing, before the picture of all directions.")},
        {{}, {{"image", "built_in"}}}};
}

// ---- [[texture]]

/// Where a texture is and what it is made of.
std::vector<Key<TextureOption>> texture_source_keys() {
    using O = TextureOption;
    const auto is_image = [](const O& o) { return o.texture.pattern == shading::Pattern::image; };
    const auto set_image = [](O& o, const std::string& path) {
        o.texture.pattern = shading::Pattern::image;
        o.image_path = path;
    };
    return {chosen_key<O>(
                "name", text(), [](O& o, const std::string& name) { o.name = name; },
                [](const O&) { return true; }, [](auto& o) { return o.name; }, "",
                "By which materials and objects name it."),
            chosen_key<O>(
                "image", image_path(), set_image, is_image, [](auto& o) { return o.image_path; },
                "", "A picture."),
            chosen_key<O>(
                "pattern", word<shading::Pattern>(),
                [](O& o, shading::Pattern pattern) { o.texture.pattern = pattern; },
                [=](const O& o) { return !is_image(o); }, [](auto& o) { return o.texture.pattern; },
                "", "A function of the place; of wood, marble and cubes, of the point in space.")};
}

/// How it is laid on the surface.
std::vector<Key<TextureOption>> texture_mapping_keys() {
    using O = TextureOption;
    return {
        key<O>(
            "mapping", word<shading::Mapping>(), [](auto& o) -> auto& { return o.texture.mapping; },
            "The mesh's own (u, v), or by an auxiliary surface about it."),
        key<O>(
            "axis", word<render::Axis>(), [](auto& o) -> auto& { return o.axis; },
            "Of cylinders, spheres and trunks; a planar mapping looks along it."),
        key<O>(
            "scale", number(1e-6, 1e6), [](auto& o) -> auto& { return o.scale; },
            "How much smaller than usual, of mappings about the mesh and in space."),
        key<O>(
            "repeat", repeats(), [](auto& o) -> auto& { return o.texture.repeat; },
            "How often it lies on the surface, along u and v."),
        key<O>(
            "offset", repeats(), [](auto& o) -> auto& { return o.texture.offset; },
            "Added to (u, v)."),
        key<O>(
            "filter", word<shading::Filter>(), [](auto& o) -> auto& { return o.texture.filter; },
            "How texels become a pixel."),
        key<O>(
            "wrap", word<shading::Wrap>(), [](auto& o) -> auto& { return o.texture.wrap; },
            "What is beyond an image's border.")};
}

/// What it gives.
std::vector<Key<TextureOption>> texture_value_keys() {
    using O = TextureOption;
    return {key<O>(
                "count", float_number(1, 10000), [](auto& o) -> auto& { return o.texture.count; },
                "Of cells, stripes or waves."),
            key<O>(
                "bend", float_number(0, 1000), [](auto& o) -> auto& { return o.texture.bend; },
                "How much marble's layers are bent."),
            key<O>(
                "low", color(), [](auto& o) -> auto& { return o.texture.low; },
                "What a pattern's 0 stands for, or an image's black."),
            key<O>(
                "high", color(), [](auto& o) -> auto& { return o.texture.high; },
                "What a pattern's 1 stands for, or an image's white."),
            key<O>(
                "height", float_number(-1e6, 1e6), [](auto& o) -> auto& { return o.height; },
                "Of a bump: how high white is, in world units.")};
}

KeyTable<TextureOption> texture_keys() {
    auto keys = texture_source_keys();
    for (const auto& more : {texture_mapping_keys(), texture_value_keys()})
        keys.insert(keys.end(), more.begin(), more.end());
    return {keys, {{{"name"}, {"image", "pattern"}}, {{"image", "pattern"}}}};
}

// ---- [[material]]

/// What a texture in that slot changes.
std::string meaning_of(TextureSlot slot) {
    switch (slot) {
        case TextureSlot::ambient:
            return "the ambient colour; that of the diffuse one if there is none";
        case TextureSlot::diffuse:
            return "the diffuse colour";
        case TextureSlot::specular:
            return "the specular colour";
        case TextureSlot::exponent:
            return "the exponent of the highlight";
        case TextureSlot::opacity:
            return "the opacity";
        case TextureSlot::bump:
            return "the surface as heights, which bend its normal";
        case TextureSlot::normal:
            return "the surface as normals";
    }
    return {};
}

std::vector<std::string> names_of_metals() {
    std::vector<std::string> names;
    for (const shading::Metal& metal : shading::metals())
        names.emplace_back(metal.name);
    return names;
}

/// What facets mirror is said in one way.
std::vector<std::pair<std::string, std::string>> reflectances() {
    return {{"ior", "metal"}, {"ior", "reflectance"}, {"metal", "reflectance"}};
}

/// A texture for each slot, by its name.
template <class O>
void add_texture_keys(std::vector<Key<O>>& keys, const std::string& fallback) {
    for (const auto& choice : words_beside(TextureSlot{})) {
        const TextureSlot slot = choice.second;
        keys.push_back(chosen_key<O>(
            choice.first + "_texture", text(),
            [slot](O& o, const std::string& name) { o.textures[slot] = name; },
            [slot](const O& o) { return !o.textures[slot].empty(); },
            [slot](auto& o) { return o.textures[slot]; }, fallback,
            "The name of the `[[texture]]` on " + meaning_of(slot) + "."));
    }
}

/// What the models with more than colours know of a surface.
std::vector<Key<MaterialOptions>> facet_keys() {
    using O = MaterialOptions;
    const auto set_index = [](O& o, double index) {
        forget_reflectance(o.facets);
        o.facets.ior = index;
    };
    const auto set_metal = [](O& o, const std::string& name) {
        forget_reflectance(o.facets);
        o.facets.metal = &parse_metal(name);
    };
    const auto set_reflectance = [](O& o, const glm::vec3& color) {
        forget_reflectance(o.facets);
        o.facets.reflectance = color;
    };
    return {optional_key<O>(
                "roughness", number(shading::FacetSlopes::least, shading::FacetSlopes::most),
                [](auto& o) -> auto& { return o.facets.roughness; }, toml_number(usual_roughness),
                "For cook-torrance: the facets' slope m, root mean square."),
            optional_key<O>(
                "distribution", word<shading::FacetDistribution>(),
                [](auto& o) -> auto& { return o.facets.distribution; },
                toml_string(word_of(usual_distribution)),
                "For cook-torrance: how the facets' slopes are distributed."),
            optional_key<O>(
                "constant", word<shading::FacetConstant>(),
                [](auto& o) -> auto& { return o.facets.constant; },
                toml_string(word_of(usual_constant)),
                "For cook-torrance: so that energy is kept, or as printed in textbooks."),
            chosen_key<O>(
                "ior", number(0.1, 100.0), set_index,
                [](const O& o) { return o.facets.ior.has_value(); },
                [](auto& o) { return *o.facets.ior; }, "the file's, or 1.5; for hall 1",
                "For cook-torrance and hall: index of refraction."),
            chosen_key<O>(
                "metal", one_of(names_of_metals()), set_metal,
                [](const O& o) { return o.facets.metal != nullptr; },
                [](auto& o) { return std::string(o.facets.metal->name); }, "none",
                "For cook-torrance: facets of this metal, as measured; the body gets its colour."),
            chosen_key<O>(
                "reflectance", color(), set_reflectance,
                [](const O& o) { return o.facets.reflectance.has_value(); },
                [](auto& o) { return *o.facets.reflectance; }, "by `ior`",
                "For cook-torrance: facets of a metal that mirrors this of the light, straight "
                "back."),
            optional_key<O>(
                "fresnel", word<FresnelForm>(), [](auto& o) -> auto& { return o.facets.form; },
                toml_string(word_of(FresnelForm::exact)),
                "For cook-torrance: an index for each channel, or (fast) one for all."),
            optional_key<O>(
                "specular_share", number(0.0, 1.0),
                [](auto& o) -> auto& { return o.facets.specular_share; }, "0.5, of metals 1",
                "For cook-torrance: K_s, what facets have of the light; the body has the rest.")};
}

/// What lets light through a surface, or throws it back as a mirror.
std::vector<Key<MaterialOptions>> optics_keys(const std::string& fallback) {
    using O = MaterialOptions;
    return {optional_key<O>(
                "mirror", color(), [](auto& o) -> auto& { return o.mirror; }, fallback,
                "What it mirrors of the environment, in Phong shading."),
            optional_key<O>(
                "refract", color(), [](auto& o) -> auto& { return o.refracted; }, fallback,
                "What of the environment is seen through it, bent by `ior`, in Phong shading."),
            optional_key<O>(
                "opacity", float_number(0.0, 1.0), [](auto& o) -> auto& { return o.opacity; },
                fallback, "1 hides what lies behind, 0 shows all of it."),
            optional_key<O>(
                "kdt", color(), [](auto& o) -> auto& { return o.transmitted_diffuse; }, fallback,
                "For hall: diffuse transmission K_dt of light from behind."),
            optional_key<O>(
                "kt", color(), [](auto& o) -> auto& { return o.transmitted_specular; }, fallback,
                "For hall: specular transmission K_t."),
            optional_key<O>(
                "nt", number(0.0, 1e30), [](auto& o) -> auto& { return o.transmitted_exponent; },
                fallback, "For hall: exponent of the transmitted highlight.")};
}

/// Colours and highlight.
std::vector<Key<MaterialOptions>> color_keys(const std::string& fallback) {
    using O = MaterialOptions;
    return {optional_key<O>(
                "ka", color(), [](auto& o) -> auto& { return o.ambient; },
                "`kd` if that is given, else " + fallback, "Ambient reflection K_a."),
            optional_key<O>(
                "kd", color(), [](auto& o) -> auto& { return o.diffuse; }, fallback,
                "Diffuse reflection K_d."),
            optional_key<O>(
                "ks", color(), [](auto& o) -> auto& { return o.specular; }, fallback,
                "Specular reflection K_s."),
            optional_key<O>(
                "n", number(0.0, 1e30), [](auto& o) -> auto& { return o.exponent; }, fallback,
                "Exponent of the highlight: the larger, the smaller.")};
}

/// What may be said of any surface.
std::vector<Key<MaterialOptions>> surface_keys(const std::string& fallback) {
    auto keys = color_keys(fallback);
    for (const auto& more : {optics_keys(fallback), facet_keys()})
        keys.insert(keys.end(), more.begin(), more.end());
    add_texture_keys(keys, fallback);
    return keys;
}

KeyTable<MaterialOptions> material_keys() {
    using O = MaterialOptions;
    KeyTable<O> table{surface_keys("the mesh's own"), {{{"name"}}, reflectances()}};
    table.keys.insert(table.keys.begin(),
                      chosen_key<O>(
                          "name", text(), [](O& o, const std::string& name) { o.name = name; },
                          [](const O&) { return true; }, [](auto& o) { return o.name; }, "",
                          "By which objects name it."));
    return table;
}

// ---- [[object]]

/// What is to be written for an object's input.
bool is_shape(const ObjectOptions& object) {
    if (object.input == "-")
        throw UsageError("standard input cannot be named in a scene file; save the mesh first");
    return names_shape(object.input);
}

KeyTable<ObjectOptions> object_keys() {
    using O = ObjectOptions;
    const auto set_input = [](O& o, const std::string& input) { o.input = input; };
    const auto get_input = [](auto& o) { return o.input; };
    KeyTable<O> table{
        {chosen_key<O>(
             "mesh", mesh_path(), set_input, [](const O& o) { return !is_shape(o); }, get_input, "",
             "What it is: a file, with its materials."),
         chosen_key<O>("shape", shape_name(), set_input, is_shape, get_input, "",
                       "What it is: a built-in shape; `scanlight shapes` lists them."),
         chosen_key<O>(
             "material", text(), [](O& o, const std::string& name) { o.material = name; },
             [](const O& o) { return !o.material.empty(); }, [](auto& o) { return o.material; },
             "the mesh's own",
             "The name of a `[[material]]`, whose keys come over the mesh's own."),
         key<O>(
             "scale", factors(), [](auto& o) -> auto& { return o.placement.scale; },
             "Larger by this, first."),
         chosen_key<O>(
             "rotate", turns(),
             [](O& o, const std::vector<Turn>& turns) { o.placement.turns = turns; },
             [](const O& o) { return !o.placement.turns.empty(); },
             [](auto& o) { return o.placement.turns; }, "none",
             "Then turned, the first turn first; counter-clockwise seen from the axis' tip."),
         key<O>(
             "translate", point(), [](auto& o) -> auto& { return o.placement.translate; },
             "Then moved by this."),
         optional_key<O>(
             "matrix", matrix(), [](auto& o) -> auto& { return o.placement.matrix; }, "none",
             "World from object, instead of all three; rows of a matrix that multiplies columns."),
         optional_key<O>(
             "shading", word<render::Shading>(), [](auto& o) -> auto& { return o.own.shading; },
             as_the_picture, "As there, for this object."),
         optional_key<O>(
             "illumination", word<shading::Illumination>(),
             [](auto& o) -> auto& { return o.own.illumination; }, as_the_picture,
             "As there, for this object."),
         optional_key<O>(
             "gouraud71_k", float_number(1e-6, 1e6),
             [](auto& o) -> auto& { return o.own.gouraud71_k; }, as_the_picture,
             "As there, for this object."),
         optional_key<O>(
             "interpolation", word<Polygons>(), [](auto& o) -> auto& { return o.polygons; },
             as_the_picture, "As there, for this object."),
         optional_key<O>(
             "perspective", word<render::Perspective>(),
             [](auto& o) -> auto& { return o.own.perspective; }, as_the_picture,
             "As there, for this object."),
         optional_key<O>(
             "cull", word<render::Cull>(), [](auto& o) -> auto& { return o.own.cull; },
             as_the_picture, "As there, for this object."),
         optional_key<O>(
             "sides", word<render::Sides>(), [](auto& o) -> auto& { return o.own.sides; },
             as_the_picture, "As there, for this object."),
         optional_key<O>(
             "normals", word<mesh::NormalWeight>(), [](auto& o) -> auto& { return o.normals; },
             as_the_picture, "As there, for this object."),
         optional_key<O>(
             "crease_deg", float_number(0.0, 180.0), [](auto& o) -> auto& { return o.crease_deg; },
             as_the_picture, "As there, for this object.")},
        {{{"mesh", "shape"}},
         {{"mesh", "shape"}, {"scale", "matrix"}, {"rotate", "matrix"}, {"translate", "matrix"}},
         {}}};
    add_texture_keys(table.keys, "the material's");
    return table;
}

std::vector<Section> all_sections() {
    const auto all = [](auto& options) -> auto& {
        return options;
    };
    const auto material = [](auto& options) -> auto& {
        return options.material;
    };
    return {
        one("camera", "From where the picture is seen.", camera_keys(), all),
        many("camera.key",
             "Where the camera is at a moment of `scanlight turntable`, which goes smoothly from "
             "one "
             "to the next. All have `view`, or all `eye`.",
             most_camera_keys, camera_key_keys(), &SceneOptions::camera_keys),
        one("render", "How the picture is drawn.", render_keys(), all),
        one("surface", "What all objects are made of, whatever their own materials say.",
            KeyTable<MaterialOptions>{surface_keys("the object's own"), {{}, reflectances()}},
            material),
        many("light", "A light. Without any there is one from the upper left.", most_lights,
             light_keys(), &SceneOptions::lights),
        one(
            "environment", "The light from far away, all around.", environment_keys(),
            [](auto& options) -> auto& { return options.environment; }),
        many("texture", "What changes over a surface, for materials and objects to name.",
             most_textures, texture_keys(), &SceneOptions::textures),
        many("material", "A surface, for objects to name.", most_materials, material_keys(),
             &SceneOptions::materials),
        many("object", "A mesh in the world.", most_objects, object_keys(), &SceneOptions::objects),
    };
}

}  // namespace

const std::vector<Section>& sections() {
    static const std::vector<Section> all = all_sections();
    return all;
}

}  // namespace scanlight::apps
