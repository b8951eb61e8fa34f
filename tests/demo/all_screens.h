#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "apps/demo/lesson.h"
#include "apps/demo/settings.h"

namespace scanlight::demo {

inline constexpr raster::Viewport small_panel{120, 90};

/// For many small pictures threads are more work than they do.
inline const apps::Means one_thread{apps::DrawPath::fast, {1, {}}};

/// Of a choice every word, of a slider both ends.
inline std::vector<double> telling_stops(const Control& control) {
    const auto stops = stops_of(control);
    if (std::holds_alternative<Choice>(control.kind)) return stops;
    return {stops.front(), stops.back()};
}

/// The control at its telling stops, the others standing as in `others`. Of corners the first is
/// moved as far as it goes.
inline std::vector<Settings> at_ends(const Lesson& lesson, const Control& control,
                                     const Settings& others) {
    if (const auto* corners = std::get_if<Corners>(&control.kind))
        return {others, with_corner_at(others, control, 0, corners->high)};
    std::vector<Settings> all;
    for (const double stop : telling_stops(control))
        all.push_back(with_value(others, lesson, control, stop));
    return all;
}

/// Where the controls start, and each at its ends with the others at their start.
inline std::vector<Settings> ends_of_controls(const Lesson& lesson) {
    std::vector<Settings> all{starting_settings(lesson)};
    for (const Control& control : lesson.controls) {
        const auto ends = at_ends(lesson, control, starting_settings(lesson));
        all.insert(all.end(), ends.begin(), ends.end());
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
