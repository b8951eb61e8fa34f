#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/shadows.h"

namespace scanlight::apps {

/// What a pixel's ray meets of one light's shadow volumes.
struct PixelShadow {
    int x, y;
    std::size_t light;                              // its place among the lights, from 0
    raster::Depth depth;                            // of what is seen
    std::vector<render::ShadowCrossing> crossings;  // from the eye on
};

/// How many volumes the surface lies in, counted from infinity back to it.
int zfail_of(const PixelShadow& shadow);

/// For people: face by face, with the counts of z-pass and z-fail as they run.
std::string shadow_text(const PixelShadow& shadow);

/// The same for programs: an array, a light each.
std::string shadows_json(const std::vector<PixelShadow>& shadows);

}  // namespace scanlight::apps
