#pragma once

#include "apps/demo/lesson.h"

namespace scanlight::demo {

// Each in a file of its own in lessons/.

Lesson edge_table_lesson();
Lesson mach_bands_lesson();
Lesson lost_highlight_lesson();
Lesson orientation_lesson();
Lesson perspective_lesson();
Lesson averaged_normals_lesson();
Lesson silhouette_lesson();
Lesson phong_terms_lesson();
Lesson cook_torrance_lesson();
Lesson shadow_volumes_lesson();
Lesson transparency_lesson();
Lesson mappings_lesson();

}  // namespace scanlight::demo
