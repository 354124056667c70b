// The figures and proofs of a tree and of a query through it.
#pragma once

#include "lesson/subjects/tree/tree_run.hpp"

namespace snug::lesson {

/// Keys: of a tree nodes depth cost of_median, and by hand of_sah; of a query visited node_tests box_tests tests
/// left_out taken found, and where the first box is wanted of_far_first; of merging area area_points loss mergers, and
/// of AABBs as of rebuilding cost_built cost of_rebuilt.
[[nodiscard]] std::vector<Figure> tree_figures(const View& view);
/// At the end of the run; none before. method: the name of the run's. query: null if there is none.
[[nodiscard]] std::vector<Proof> tree_proofs(const View& view, const QueryPlaces* query);

}  // namespace snug::lesson
