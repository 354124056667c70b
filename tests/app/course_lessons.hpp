// The lessons of this clone, as tests of the front end read them.
#pragma once

#include <string>

#include "lesson/lesson.hpp"

namespace snug::app {

/// lessons/ID.toml as it is written; "cases/twins" is that of a case. asks: with its questions. The test ends where the
/// lesson is not sound.
lesson::Lesson course_lesson(const std::string& id, bool asks = true);

}  // namespace snug::app
