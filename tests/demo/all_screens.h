#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "apps/demo/lesson.h"
#include "apps/demo/settings.h"

namespace scanlight::demo {

inline constexpr raster::Viewport small_panel{120, 90};

/// For many small pictures threads are more work than they do.
inline const apps::Means one_thread{apps::DrawPath::fast, {1, {}}};

/// Where the controls start, and each at its first and last stop with the others at their start.
inline std::vector<Settings> ends_of_controls(const Lesson& lesson) {
    std::vector<Settings> all{starting_settings(lesson)};
    for (const Control& control : lesson.controls) {
        for (const double stop : {stops_of(control).front(), stops_of(control).back()}) {
            all.push_back(starting_settings(lesson));
            all.back()[control.name] = stop;
        }
    }
    return all;
}

inline std::string lesson_test_name(const testing::TestParamInfo<Lesson>& info) {
    std::string name = info.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
}

// What a failing parameterized test prints.
inline void PrintTo(const Lesson& lesson, std::ostream* out) {
    *out << lesson.name;
}

}  // namespace scanlight::demo
