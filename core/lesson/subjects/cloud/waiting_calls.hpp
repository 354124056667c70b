// Welzl's list and the calls of his recursion at a step of a trace, derived from its facts.
#pragma once

#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// One call of solve. Its list is the part of the whole list before the point that its caller waits at.
struct WaitingCall {
  fit::Support boundary;  // the points fixed on the boundary, in the order in which they were fixed
  int length = 0;         // how many points its list has
  int done = 0;           // how many of these it has visited, from the front
  Index at = kNoIndex;    // the point that it tests, or waits at; kNoIndex between two points
};

struct WelzlState {
  std::vector<Index> list;         // the points' order, front first
  std::vector<WaitingCall> calls;  // the outermost first; the last one runs, all others wait
  Index moved = kNoIndex;          // the point that this step moved to the front, and
  int moved_from = 0;              // the place where it was, counted from 0
};

/// The state after the first `steps` steps: without a list if the trace is not Welzl's, without calls once all have
/// ended. One pass over the trace, plus the moves to the front.
[[nodiscard]] WelzlState welzl_state(FitTrace trace, int steps);

}  // namespace snug::lesson
