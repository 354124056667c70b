// Welzl's list and the calls of his recursion at a step of a trace, read off its facts.
#pragma once

#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// One call of solve. Its list is the part of the one list that stands before the point that its caller waits at.
struct WaitingCall {
  fit::Support boundary;  // the points that are fixed on it, in the order in which they came
  int length = 0;         // how many points its list has
  int done = 0;           // so many of these it has been through, from the front
  Index at = kNoIndex;    // the point that it tests, or waits at; kNoIndex where it is between two
};

struct WelzlState {
  std::vector<Index> list;         // the points' order, front first
  std::vector<WaitingCall> calls;  // the outermost first; the last one runs, all others wait
  Index moved = kNoIndex;          // by this step to the front, and
  int moved_from = 0;              // the place, counted from 0, that it came from
};

/// After so many steps. Without a list where the trace is not Welzl's; without calls when all are over. One pass over
/// the trace, and what it takes to move the points to the front.
[[nodiscard]] WelzlState welzl_state(FitTrace trace, int steps);

}  // namespace snug::lesson
