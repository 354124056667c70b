// The lessons of this clone, as tests read and open them.
#pragma once

#include <string>

#include "lesson/session.hpp"

namespace snug::test {

/// The folder lessons/, with a slash at its end. The file that defines this is compiled with the clone's place, and no
/// other, so that clones share what ccache keeps of all others.
const std::string& lessons_folder();

/// The text of a file in lessons/ ("README.md"). The test ends where it cannot be read.
std::string lessons_file(const std::string& name);

/// lessons/ID.toml, read. The test ends where the lesson is not sound.
lesson::Lesson lesson_of(const std::string& id);

/// lessons/ID.toml, opened.
lesson::Session session_of(const std::string& id);

}  // namespace snug::test
