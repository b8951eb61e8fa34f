#include "apps/scene/object_keys.h"

#include "apps/scene/model.h"
#include "apps/scene/toml_number.h"
#include "apps/scene/usage_error.h"

namespace scanlight::apps {

// ---- [[texture]]

namespace {

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

}  // namespace

KeyTable<TextureOption> texture_keys() {
    auto keys = texture_source_keys();
    for (const auto& more : {texture_mapping_keys(), texture_value_keys()})
        keys.insert(keys.end(), more.begin(), more.end());
    return {keys, {{{"name"}, {"image", "pattern"}}, {{"image", "pattern"}}}};
}

// ---- [[material]]

namespace {

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
    return {
        optional_key<O>(
            "mirror", color(), [](auto& o) -> auto& { return o.mirror; }, fallback,
            "What it mirrors of the environment, in Phong shading."),
        optional_key<O>(
            "refract", color(), [](auto& o) -> auto& { return o.refracted; }, fallback,
            "What of the environment is seen through it, bent by `ior`, in Phong shading."),
        optional_key<O>(
            "opacity", float_number(0.0, 1.0), [](auto& o) -> auto& { return o.opacity; }, fallback,
            "1 hides what lies behind, 0 shows all of it; what is not 1 casts no shadow."),
        optional_key<O>(
            "tf", color(), [](auto& o) -> auto& { return o.filter; }, fallback,
            "What is left of light that comes through, where `opacity` is not 1."),
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
std::vector<Key<MaterialOptions>> material_keys(const std::string& fallback) {
    auto keys = color_keys(fallback);
    for (const auto& more : {optics_keys(fallback), facet_keys()})
        keys.insert(keys.end(), more.begin(), more.end());
    add_texture_keys(keys, fallback);
    return keys;
}

}  // namespace

KeyTable<MaterialOptions> material_keys() {
    using O = MaterialOptions;
    KeyTable<O> table{material_keys("the mesh's own"), {{{"name"}}, reflectances()}};
    table.keys.insert(table.keys.begin(),
                      chosen_key<O>(
                          "name", text(), [](O& o, const std::string& name) { o.name = name; },
                          [](const O&) { return true; }, [](auto& o) { return o.name; }, "",
                          "By which objects name it."));
    return table;
}

KeyTable<MaterialOptions> surface_keys() {
    return {material_keys("the object's own"), {{}, reflectances()}};
}

// ---- [[object]]

namespace {

/// What is to be written for an object's input.
bool is_shape(const ObjectOptions& object) {
    if (object.input == "-")
        throw UsageError("standard input cannot be named in a scene file; save the mesh first");
    return names_shape(object.input);
}

}  // namespace

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

}  // namespace scanlight::apps
