// The versions of the lesson format, and what to change in a file of an older one.
#pragma once

#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The version that this program reads.
inline constexpr std::int64_t kLessonVersion = 2;

/// Complains about everything in a file of version 1 that version 2 writes differently, and says how.
void tell_changes(const toml::table& toml, Complaints& complaints);

}  // namespace snug::lesson
