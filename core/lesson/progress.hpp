// How far a student has come in a lesson: worked out here for both doors, from what was done in all of its runs.
#pragma once

#include "lesson/session.hpp"

namespace snug::lesson {

struct Progress {
  bool begun = false;  // whether anything was done in it
  int answered = 0;    // of its questions; skipped ones are not among them
  int asked = 0;       // all that it asks, of every algorithm and in every situation
  /// Whether each question was answered, right or wrong, and each slider that it is about was moved. A lesson that asks
  /// nothing: whether its end was reached.
  bool done = false;
  bool task = false;  // whether all of its tasks were done
};

[[nodiscard]] Progress progress_of(const Session& session);

}  // namespace snug::lesson
