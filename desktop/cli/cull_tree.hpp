// Culls with a tree over the volumes, and compares that with culling one by one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "desktop/cli/trace_file.hpp"
#include "geometry/frustum.hpp"
#include "geometry/volume.hpp"
#include "query/cull/classify_steps.hpp"

namespace snug::desktop {

inline const std::vector<std::string> kTreeRules{"median", "surface_area", "bottom_up", "insertion"};

/// The cost of all volumes together.
struct CullCost {
  std::int64_t volume_tests = 0;
  std::int64_t planes_tested = 0;
};

struct CulledByTree {
  std::vector<query::Culling> classes;  // those of the volumes
  std::int64_t nodes = 0, nodes_visited = 0;
  int depth = 0;
  double cost = 0;  // hierarchy::expected_cost
  CullCost by_tree, without_masks, one_by_one;
};

/// How a tree is built.
struct TreeRule {
  std::string name;           // one of kTreeRules
  std::int64_t most_in_leaf;  // >= 1; of the rules that build from the root down
};

/// volumes: all of one kind. trace: receives the steps of building and of the traversal.
/// Returns nothing for a kind whose volumes do not merge: there are no trees of it.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<CulledByTree> cull_by_tree(const TreeRule& rule, const Frustum<Scalar, Dim>& frustum,
                                                       std::span<const Volume<Scalar, Dim>> volumes, TraceFile& trace);

}  // namespace snug::desktop
