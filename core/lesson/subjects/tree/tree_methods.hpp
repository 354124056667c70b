// The ways to build a tree, and the queries that go through one, with their steps.
#pragma once

#include <span>
#include <string_view>
#include <variant>

#include "hierarchy/steps.hpp"
#include "lesson/subjects/tree/forest.hpp"
#include "query/cull/classify_steps.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The volumes of lessons about trees: how they are built, how queries go through them, and what becomes of them when
/// boxes have moved.
inline constexpr std::string_view kTreeBuild = "bvh_build", kTreeQuery = "bvh_query", kTreeUpdate = "bvh_update";
[[nodiscard]] inline bool is_query(std::string_view volume) { return volume == kTreeQuery; }

struct TreeStep {
  using Fact = std::variant<hierarchy::SplitsPriced, hierarchy::SplitChosen, hierarchy::LeafMade,
                            hierarchy::NodesMerged, hierarchy::BodyInserted, hierarchy::Rotated, hierarchy::VolumeMade,
                            hierarchy::NodeVisited, hierarchy::BodyTested, hierarchy::PairTested, hierarchy::Done>;
  int line = 0;
  Fact fact;
};
using TreeTrace = std::vector<Recorder<TreeStep>::Entry>;
using TreeSteps = std::span<const Recorder<TreeStep>::Entry>;

/// The method by which a student builds: by_hand.
inline constexpr std::string_view kByHand = "by_hand";
/// top_down_median, top_down_sah, bottom_up, insertion.
[[nodiscard]] std::span<const Method> build_methods();
/// The same, and by_hand.
[[nodiscard]] std::span<const Method> build_methods_and_hand();
/// The method by which a student chooses which child comes next, and the one that sends a tree through another.
inline constexpr std::string_view kRayByHand = "ray_by_hand", kTwoTrees = "two_trees";
/// point_query, box_query, ray_query, ray_far_first, ray_nearest, ray_by_hand, frustum_query, two_trees.
[[nodiscard]] std::span<const Method> query_methods();

/// Builds a tree whose leaves have one box each. trace: null, or where its steps are appended; a node's volume is no
/// step of its own. method: the name of a build method.
[[nodiscard]] TreeOfBoxes build_tree(std::string_view method, std::span<const Box2> boxes, TreeTrace* trace = nullptr);
/// The tree that mergers by hand make. pairs: all that it takes.
[[nodiscard]] TreeOfBoxes tree_by_hand(std::span<const HandPair> pairs, std::span<const Box2> boxes);
/// The cost of a whole tree by the surface-area heuristic, where its nodes have volumes of this kind.
[[nodiscard]] double cost_of_tree(const TreeOfBoxes& tree, std::span<const Box2> boxes, NodeKind kind);
[[nodiscard]] Growth::Way way_of(std::string_view method);

/// A query's shape, by the method that asks it.
enum class QueryShape : std::uint8_t { kPoint, kBox, kRay, kFrustum, kMove };
[[nodiscard]] QueryShape shape_of_query(std::string_view method);
/// Whether the method looks for the first box on a ray.
[[nodiscard]] inline bool finds_first(std::string_view method) {
  return method == "ray_nearest" || method == "ray_far_first" || method == kRayByHand;
}
/// From Q, with the middle of its far side at R. Errors: Q and R are in one place, or too far apart.
[[nodiscard]] tl::expected<Frustum<double, 2>, InputError> frustum_of(const QueryPlaces& query);
/// Its vertices, in order around it.
[[nodiscard]] std::array<Point2, 4> corners_of_query(const QueryPlaces& query);
/// With Q and R as opposite vertices.
[[nodiscard]] Box2 box_of(const QueryPlaces& query);

struct QueryResult {
  hierarchy::Counts counts;
  std::vector<Index> found;  // rising; the nearest alone, if that is what is asked for
  std::int64_t planes_tested = 0;
  std::vector<Index> right_first;  // the nodes whose right child is taken first, where a ray looks for the first box
  std::size_t chosen = 0;          // how many choices by hand were needed
  Index undecided = kNoIndex;      // the node at which the next choice is due: the query ends there, with no result
};
/// Sends a query through a tree. trace: null, or where its steps are appended. method: the name of a query method, but
/// not two_trees. choices: of ray_by_hand, for each node whose children are both met, 1 if the right one comes first.
[[nodiscard]] QueryResult run_query(std::string_view method, const QueryPlaces& query, const TreeOfBoxes& tree,
                                    std::span<const Box2> boxes, TreeTrace* trace = nullptr,
                                    std::span<const Index> choices = {});
/// The same boxes, found by testing each.
[[nodiscard]] std::vector<Index> found_one_by_one(std::string_view method, const QueryPlaces& query,
                                                  std::span<const Box2> boxes);

}  // namespace snug::lesson
