#include "apps/scene/words.h"

namespace scanlight::apps {

Words<render::Shading> words_beside(render::Shading) {
    using enum render::Shading;
    return {{"flat", flat}, {"gouraud", gouraud}, {"phong", phong}};
}

Words<shading::Illumination> words_beside(shading::Illumination) {
    using enum shading::Illumination;
    return {{"lambert", lambert}, {"gouraud71", gouraud71}, {"phong", phong},
            {"blinn", blinn},     {"hall", hall},           {"cook-torrance", cook_torrance}};
}

Words<shading::FacetDistribution> words_beside(shading::FacetDistribution) {
    using enum shading::FacetDistribution;
    return {{"beckmann", beckmann}, {"gauss", gauss}, {"cosine", cosine}};
}

Words<shading::FacetConstant> words_beside(shading::FacetConstant) {
    using enum shading::FacetConstant;
    return {{"normalised", normalised}, {"textbook", textbook}};
}

Words<FresnelForm> words_beside(FresnelForm) {
    using enum FresnelForm;
    return {{"exact", exact}, {"fast", fast}};
}

Words<TextureSlot> words_beside(TextureSlot) {
    using enum TextureSlot;
    return {{"diffuse", diffuse},   {"specular", specular}, {"ambient", ambient},
            {"exponent", exponent}, {"opacity", opacity},   {"bump", bump},
            {"normal", normal}};
}

Words<shading::Pattern> words_beside(shading::Pattern) {
    using enum shading::Pattern;
    return {{"checker", checker}, {"stripes", stripes}, {"gradient", gradient},  {"waves", waves},
            {"wood", wood},       {"marble", marble},   {"cubes", solid_checker}};
}

Words<shading::Mapping> words_beside(shading::Mapping) {
    using enum shading::Mapping;
    return {{"uv", uv},
            {"planar", planar},
            {"cylindrical", cylindrical},
            {"chapter-cylinder", chapter_cylinder},
            {"spherical", spherical}};
}

Words<shading::Filter> words_beside(shading::Filter) {
    using enum shading::Filter;
    return {{"nearest", nearest}, {"bilinear", bilinear}, {"trilinear", trilinear}};
}

Words<shading::Wrap> words_beside(shading::Wrap) {
    using enum shading::Wrap;
    return {{"repeat", repeat}, {"clamp", clamp}, {"mirror", mirror}};
}

Words<render::Axis> words_beside(render::Axis) {
    using enum render::Axis;
    return {{"x", x}, {"y", y}, {"z", z}};
}

Words<shading::Falloff> words_beside(shading::Falloff) {
    using enum shading::Falloff;
    return {{"constant", constant},
            {"inverse", inverse},
            {"inverse-square", inverse_square},
            {"inverse-plus-k", inverse_plus_k}};
}

Words<Polygons> words_beside(Polygons) {
    using enum Polygons;
    return {{"bilinear", bilinear}, {"triangulated", triangulated}};
}

Words<render::Perspective> words_beside(render::Perspective) {
    using enum render::Perspective;
    return {{"correct", correct}, {"affine", affine}};
}

Words<render::Cull> words_beside(render::Cull) {
    using enum render::Cull;
    return {{"none", none}, {"back", back}, {"front", front}};
}

Words<render::Sides> words_beside(render::Sides) {
    using enum render::Sides;
    return {{"one", one}, {"two", two}};
}

Words<render::Distances> words_beside(render::Distances) {
    using enum render::Distances;
    return {{"finite", finite}, {"infinite", infinite}};
}

Words<render::Shadows> words_beside(render::Shadows) {
    using enum render::Shadows;
    return {{"none", none},   {"zpass", zpass}, {"zpass-from-zero", zpass_from_zero},
            {"zfail", zfail}, {"map", map},     {"polygons", polygons}};
}

Words<shading::EnvironmentLayout> words_beside(shading::EnvironmentLayout) {
    using enum shading::EnvironmentLayout;
    return {{"latitudes", latitudes}, {"sphere", sphere}, {"cube", cube}};
}

Words<Show> words_beside(Show) {
    using enum Show;
    return {{"light", light}, {"stencil", stencil}, {"details", details}, {"fresnel", fresnel}};
}

Words<mesh::NormalWeight> words_beside(mesh::NormalWeight) {
    using enum mesh::NormalWeight;
    return {{"mean", mean}, {"area", area}, {"angle", angle}, {"file", file}};
}

Words<render::Projection> words_beside(render::Projection) {
    using enum render::Projection;
    return {{"perspective", perspective}, {"orthographic", orthographic}};
}

}  // namespace scanlight::apps
