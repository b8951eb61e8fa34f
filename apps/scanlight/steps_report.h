#pragma once

#include <string>
#include <vector>

#include "render/steps.h"

namespace scanlight::apps {

/// The steps of one polygon for people: its corners, the edge table, then scanline by scanline the
/// active edge table and the spans, with every increment.
std::string steps_text(const render::PolygonSteps& steps, const std::string& title);

/// The same numbers for programs; an array of polygons.
std::string steps_json(const std::vector<render::PolygonSteps>& polygons);

/// A colour whose channels never differ is one intensity: I for I_r, I_g, I_b.
render::PolygonSteps with_grey_as_one(render::PolygonSteps steps);

}  // namespace scanlight::apps
