#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/demo/lesson.h"

namespace scanlight::demo {

/// All controls where they start.
Settings starting_settings(const Lesson& lesson);

/// The values of a control that a page shows: a slider's stops, or each word of a choice; none of
/// corners.
std::vector<double> stops_of(const Control& control);

/// The value of a slider or choice as the command line has it: "12.5", or a choice's word.
std::string value_text(const Control& control, double value);

/// Where a control stands, as the command line has it: a value, or corners as "X,Y:X,Y:X,Y".
std::string text_of(const Control& control, const Settings& settings);

/// "CONTROL=VALUE" for each control that does not stand where it starts, as `set` takes them.
std::vector<std::string> assignments_of(const Lesson& lesson, const Settings& settings);

/// The nearest value that a slider or choice can have, with as many digits as the command line
/// gives it.
double held(const Control& control, double value);

/// The nearest place that a corner can have.
glm::dvec2 held(const Corners& corners, const glm::dvec2& place);

/// A slider or choice set to a value that it can have. Corners that start as a choice has them are
/// put back when it is set.
Settings with_value(Settings settings, const Lesson& lesson, const Control& control, double value);

/// The polygon of a control of corners, where it stands.
const Polygon& polygon_of(const Control& control, const Settings& settings);

/// One of its corners moved to the nearest place that it can have.
Settings with_corner_at(Settings settings, const Control& control, std::size_t corner,
                        const glm::dvec2& place);

/// "CONTROL=VALUE" over the settings. Throws UsageError or FileError, which says what was expected,
/// for a control that the lesson has not, and a value out of range.
void set(Settings& settings, const Lesson& lesson, const std::string& assignment);

/// The first control at its `frame`-th stop, from 0. Throws UsageError beyond the last.
void set_frame(Settings& settings, const Lesson& lesson, int frame);

/// The control of this name. Throws UsageError, which names them all, where there is none.
const Control& control_named(const Lesson& lesson, const std::string& name);

/// Which of its words a choice has.
const std::string& word_of(const std::vector<std::string>& words, const Settings& settings,
                           const std::string& choice);

}  // namespace scanlight::demo
