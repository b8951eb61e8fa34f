#include "apps/scanlight/words.h"

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
    return {{"latitudes", latitudes}, {"sphere", sphere}};
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

Words<DrawPath> words_beside(DrawPath) {
    using enum DrawPath;
    return {{"fast", fast}, {"textbook", textbook}};
}

}  // namespace scanlight::apps
