// The calls of Welzl's recursion as lectures print it, at a step of a trace, derived from its facts.
#pragma once

#include <cstdint>
#include <vector>

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

/// One call, with the points of its list that it was made for and those on the boundary.
struct TreeCall {
  int parent = -1;         // the call that made it; -1 for the first
  int depth = 1;           // how many calls are open while it runs
  Index point = kNoIndex;  // the point that it removed; kNoIndex if it had none to remove, or was stopped
  Index left = 0;          // how many points it was made for
  fit::Support boundary = {};
  bool again = false;    // whether its caller made it as the second of its two calls
  bool decided = false;  // whether its first call has returned, and its point was tested
  bool open = true;      // false: it has returned
};

struct CallTree {
  std::vector<TreeCall> calls;  // in the order in which they were made, so that callers stand before their calls
  std::vector<int> open;        // those that have not returned, the outermost first; the last one runs
  int deepest = 0;              // the greatest number of open calls so far
  std::int64_t bytes = 0;       // what the open calls keep
  int stopped_at = 0;           // the depth at which the recursion was stopped; 0 if it was not
};

/// The calls after the first `steps` steps; empty if the trace has none. One pass over the trace.
[[nodiscard]] CallTree call_tree(FitTrace trace, int steps);

/// Whether the trace is that of the recursion.
[[nodiscard]] bool has_calls(FitTrace trace);

}  // namespace snug::lesson
