// How far the exact search for the smallest box has come: the pairs of edges that it still has to try or rule out.
#pragma once

#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::lesson {

struct EdgePairs {
  std::int64_t all = 0;        // of the whole search
  std::int64_t left = 0;       // neither tried nor ruled out so far
  std::int64_t ruled_out = 0;  // so far, each by one bound
  std::int64_t halvings = 0;   // so far
};

/// After the first `steps` steps of a trace; no pairs if it is not a trace of that search. One pass over the trace.
[[nodiscard]] EdgePairs edge_pairs(FitTrace trace, int steps);

}  // namespace snug::lesson
