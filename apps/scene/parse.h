#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "apps/scene/material_options.h"
#include "raster/project.h"
#include "render/framing.h"
#include "shading/falloff.h"
#include "shading/metals.h"

namespace scanlight::apps {

// The words of the command line as values. All throw UsageError, which shows what was expected.

double parse_number(std::string_view text, std::string_view what);

/// "640x480": 1 to 16384 each way.
raster::Viewport parse_size(std::string_view text);

/// 1, 4 or 16 samples a pixel: how many each way.
int parse_samples(std::string_view text);

/// "AZ,EL" in degrees.
render::ViewAngles parse_view(std::string_view text);

/// "x,y,z"
glm::dvec3 parse_point(std::string_view text, std::string_view what);

/// "#rrggbb" or "#rgb" as in sRGB, or "r,g,b" or one grey number as linear light. Linear result.
glm::vec3 parse_color(std::string_view text);

/// Where a light stands.
enum class LightFrame { camera, world, point };

struct LightOption {
    LightFrame frame = LightFrame::camera;
    glm::dvec3 place{0.0};  // towards the light; of a point light its position in the world
    glm::vec3 color{1.0f};  // linear
    shading::Falloff falloff = shading::Falloff::constant;
    std::optional<float> falloff_k = {};  // the picture's where it is not given
};

/// "[camera:|world:|point:]x,y,z[,#colour][,constant|inverse|inverse-square|inverse-plus-k]"
LightOption parse_light(std::string_view text);

/// "ka=COLOUR kd=COLOUR ks=COLOUR n=NUMBER mirror=COLOUR refract=COLOUR opacity=NUMBER tf=COLOUR
/// kdt=COLOUR kt=COLOUR nt=NUMBER", any of them.
MaterialOptions parse_material(std::string_view text);

/// What they are called, with commas between.
std::string metal_names();

/// One of `shading::metals()` by its name.
const shading::Metal& parse_metal(std::string_view text);

}  // namespace scanlight::apps
