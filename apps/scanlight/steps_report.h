#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/scanlight/scene_options.h"
#include "apps/scene/json.h"
#include "render/camera.h"
#include "render/steps.h"

namespace scanlight::apps {

/// The steps of one polygon for people: its corners, the edge table, then scanline by scanline the
/// active edge table and the spans, with every increment.
std::string steps_text(const render::PolygonSteps& steps, const std::string& title);

/// What the steps were traced from.
struct StepsSource {
    const SceneOptions& options;
    const render::Camera& camera;
    std::size_t polygons_seen;  // of which some are shown
};

/// The same numbers for programs: a header that says what is shown, and an array of polygons.
std::string steps_json(const StepsSource& source,
                       const std::vector<render::PolygonSteps>& polygons);

/// Those of one polygon.
Json polygon_json(const render::PolygonSteps& steps);

/// A colour whose channels never differ is one intensity: I for I_r, I_g, I_b.
render::PolygonSteps with_grey_as_one(render::PolygonSteps steps);

}  // namespace scanlight::apps
