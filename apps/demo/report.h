#pragma once

#include <string>

#include "apps/demo/lesson.h"
#include "apps/demo/texts.h"

namespace scanlight::demo {

/// The lessons' names and titles, a line each.
std::string list_text(Language language);

/// A lesson for a terminal: its words, its controls, what the engine found, and the commands that
/// draw its pictures.
std::string lesson_text(const Lesson& lesson, const Settings& settings, const Screen& screen,
                        Language language);

}  // namespace scanlight::demo
