#include "apps/demo/lessons.h"

#include <algorithm>

#include "apps/scene/usage_error.h"

namespace scanlight::demo {

const std::vector<Lesson>& lessons() {
    static const std::vector<Lesson> all{
        edge_table_lesson(),     mach_bands_lesson(),   lost_highlight_lesson(),
        orientation_lesson(),    perspective_lesson(),  averaged_normals_lesson(),
        silhouette_lesson(),     phong_terms_lesson(),  cook_torrance_lesson(),
        shadow_volumes_lesson(), transparency_lesson(), mappings_lesson(),
    };
    return all;
}

const Lesson& lesson_named(const std::string& name) {
    const auto found = std::ranges::find(lessons(), name, &Lesson::name);
    if (found != lessons().end()) return *found;
    std::string names;
    for (const Lesson& lesson : lessons())
        names += " " + lesson.name;
    throw apps::UsageError("no lesson is named '" + name + "'; there are:" + names);
}

}  // namespace scanlight::demo
