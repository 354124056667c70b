// What a press of a demo reveals of a question (demo.cpp).
#pragma once

#include "lesson/session.hpp"

namespace snug::lesson {

/// Tells the outcome of the question that stands open, skipped, at the step that decides it. The others of this run are
/// passed: one that waits at the same step would keep that from being played.
void reveal_answer(Session& session);

}  // namespace snug::lesson
