#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "apps/scene/scene_options.h"

namespace scanlight::apps {

template <class Choice>
using Words = std::vector<std::pair<std::string, Choice>>;

// What the values of a choice are called on the command line and in reports, all of them, whichever
// is given.

Words<render::Shading> words_beside(render::Shading);
Words<shading::Illumination> words_beside(shading::Illumination);
Words<shading::FacetDistribution> words_beside(shading::FacetDistribution);
Words<shading::FacetConstant> words_beside(shading::FacetConstant);
Words<FresnelForm> words_beside(FresnelForm);
Words<TextureSlot> words_beside(TextureSlot);
Words<shading::Pattern> words_beside(shading::Pattern);  // all but images
Words<shading::Mapping> words_beside(shading::Mapping);
Words<shading::Filter> words_beside(shading::Filter);
Words<shading::Wrap> words_beside(shading::Wrap);
Words<render::Axis> words_beside(render::Axis);
Words<shading::Falloff> words_beside(shading::Falloff);
Words<Polygons> words_beside(Polygons);
Words<render::Perspective> words_beside(render::Perspective);
Words<render::Cull> words_beside(render::Cull);
Words<render::Sides> words_beside(render::Sides);
Words<render::Distances> words_beside(render::Distances);
Words<render::Shadows> words_beside(render::Shadows);
Words<Show> words_beside(Show);
Words<shading::EnvironmentLayout> words_beside(shading::EnvironmentLayout);
Words<mesh::NormalWeight> words_beside(mesh::NormalWeight);
Words<render::Projection> words_beside(render::Projection);

template <class Choice>
std::string word_of(Choice value) {
    const auto words = words_beside(value);
    return std::ranges::find(words, value, &std::pair<std::string, Choice>::second)->first;
}

}  // namespace scanlight::apps
