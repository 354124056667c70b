#include "lesson/subjects/cloud/edge_pairs.hpp"

namespace snug::lesson {

EdgePairs edge_pairs(FitTrace trace, int steps) {
  EdgePairs pairs;
  for (int i = 0; i < static_cast<int>(trace.size()); ++i) {
    const auto* edge = std::get_if<fit::EdgeSearched>(&trace[i].step.fact);
    if (edge == nullptr) continue;
    pairs.all += edge->pairs;
    if (i >= steps) pairs.left += edge->pairs;
    else pairs.ruled_out += edge->ruled_out, pairs.halvings += edge->halvings;
  }
  return pairs;
}

}  // namespace snug::lesson
