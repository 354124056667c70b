// The figures and proofs of a tree and of a query through it.
#pragma once

#include "lesson/subjects/tree/tree_run.hpp"

namespace snug::lesson {

/// Keys: of a tree nodes depth cost of_median, by hand of_sah, and of other nodes than AABBs of_aabb; of a query
/// visited node_tests box_tests tests left_out taken found, where the first box is wanted of_far_first instead of
/// taken, and by hand of_near_first; of two trees the same without taken, and of_all; of merging area area_points loss
/// mergers, and of AABBs as of rebuilding cost_built cost of_rebuilt.
[[nodiscard]] std::vector<Figure> tree_figures(const View& view);
/// At the end of the run; none before. method: the name of the run's. query: null if there is none.
[[nodiscard]] std::vector<Proof> tree_proofs(const View& view, const QueryPlaces* query);

}  // namespace snug::lesson
