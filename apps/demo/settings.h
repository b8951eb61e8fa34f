#pragma once

#include <string>
#include <vector>

#include "apps/demo/lesson.h"

namespace scanlight::demo {

/// All controls where they start.
Settings starting_settings(const Lesson& lesson);

/// The values of a control that a page shows: a slider's stops, or each word of a choice.
std::vector<double> stops_of(const Control& control);

/// The value as the command line has it: "12.5", or a choice's word.
std::string value_text(const Control& control, double value);

/// The nearest value that the control can have, with as many digits as the command line gives it.
double held(const Control& control, double value);

/// "CONTROL=VALUE" over the settings. Throws UsageError, which says what was expected, for a
/// control that the lesson has not, and a value out of range.
void set(Settings& settings, const Lesson& lesson, const std::string& assignment);

/// The first control at its `frame`-th stop, from 0. Throws UsageError beyond the last.
void set_frame(Settings& settings, const Lesson& lesson, int frame);

/// A choice's word.
const std::string& word_of(const Lesson& lesson, const Settings& settings,
                           const std::string& control);

}  // namespace scanlight::demo
