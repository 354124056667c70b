// A run of a method on a tree: its steps, and what stands after each of them.
#pragma once

#include "hierarchy/traverse.hpp"
#include "lesson/facts.hpp"
#include "lesson/subjects/tree/tree_merge.hpp"
#include "lesson/subjects/tree/tree_pair.hpp"

namespace snug::lesson {

/// What a query has made of a node or of a box so far.
enum class Met : std::uint8_t {
  kNot,     // nothing yet
  kOpen,    // it waits
  kMet,     // it was taken up, and the query meets it
  kMissed,  // it was tested and left out
  kUnder,   // left out untested, with what is above it
  kTaken,   // taken untested, since what is above it is inside
};

/// What a query has done so far.
struct QueryState {
  std::vector<Met> nodes, boxes;
  std::vector<Index> waiting;  // the open nodes; the last is the next one
  std::int64_t visited = 0, node_tests = 0, box_tests = 0;
  [[nodiscard]] std::int64_t tests() const { return node_tests + box_tests; }
  /// The boxes that are found by now.
  [[nodiscard]] std::vector<Index> found() const;
};

class TreeRun final : public FactRun<TreeRun, TreeStep> {
 public:
  /// Builds a tree. kind: that of its nodes' volumes.
  TreeRun(std::string_view method, std::vector<Box2> boxes, NodeKind kind = NodeKind::kAabb);
  /// Builds a tree by the mergers that were chosen by hand; it may not be finished. pairs: of groups that are there.
  TreeRun(std::vector<Box2> boxes, std::span<const HandPair> pairs, NodeKind kind = NodeKind::kAabb);
  /// Sends a query through a tree that is built by a rule; or tests the tree against its copy. choices: by hand, of the
  /// children that come first.
  TreeRun(std::string_view method, std::vector<Box2> boxes, std::string_view rule, const QueryPlaces& query,
          std::span<const Index> choices = {});

  /// Merges the volumes of a tree, or rebuilds it, after its boxes have moved. built: as they were when it was built.
  TreeRun(std::string_view method, std::vector<Box2> boxes, std::span<const Box2> built);

  [[nodiscard]] TreeSteps trace() const { return trace_; }
  [[nodiscard]] const std::vector<Box2>& boxes() const { return boxes_; }
  [[nodiscard]] bool is_by_hand() const { return by_hand_; }
  /// Whether a node is tested before it waits, as where a ray looks for the first box.
  [[nodiscard]] bool tests_before() const { return first_; }
  /// Whether the tree is finished at the end; by hand, it may not be.
  [[nodiscard]] bool is_whole() const { return !tree_.nodes.empty(); }
  [[nodiscard]] bool is_query() const { return !states_.empty(); }
  /// Two trees against each other; null for anything else.
  [[nodiscard]] const TreePairing* pairing() const { return pairing_ ? &*pairing_ : nullptr; }
  /// Whether the student chooses which child comes next; and the node at which a choice is due, kNoIndex for none.
  [[nodiscard]] bool is_steered() const { return steered_; }
  [[nodiscard]] Index undecided() const { return result_.undecided; }
  /// Whether it merges volumes: then the tree stands from the beginning, and its nodes get their volumes.
  [[nodiscard]] bool is_merging() const { return !volumes_.merged.empty(); }
  /// Whether it is about a tree whose boxes have moved.
  [[nodiscard]] bool is_update() const { return before_.has_value(); }
  /// The tree before the move, as it was built, and what it cost then.
  [[nodiscard]] const Forest& before() const { return before_->forest; }
  [[nodiscard]] double cost_built() const { return before_->cost; }
  /// Whether a node has its merged volume after so many steps; and all of these volumes.
  [[nodiscard]] bool has_volume(Index node, int steps) const {
    return node >= static_cast<Index>(tree_.nodes.size()) - steps;
  }
  [[nodiscard]] const MergedVolumes& volumes() const { return volumes_; }
  /// "AABB", "circle", "OBB".
  [[nodiscard]] std::string_view volume_word() const { return word_; }
  [[nodiscard]] Growth::Way way() const { return way_; }
  [[nodiscard]] NodeKind nodes() const { return nodes_; }
  /// The finished tree, and its cost (hierarchy::expected_cost; expected_cost where its nodes are no AABBs).
  [[nodiscard]] const TreeOfBoxes& tree() const { return tree_; }
  [[nodiscard]] double cost() const;
  /// What stands after so many steps. A tree that is not being built stands from the beginning.
  [[nodiscard]] const Forest& forest(int steps) const { return forests_[forests_.size() == 1 ? 0 : steps]; }
  /// How far the query has come after so many steps; its result; where it is.
  [[nodiscard]] const QueryState& state(int steps) const { return states_[steps]; }
  [[nodiscard]] const QueryResult& result() const { return result_; }
  [[nodiscard]] const QueryPlaces& query() const { return query_; }
  /// The branch that a step is about, in the forest before it: the one that it divides, tests, or merges into; kNoIndex
  /// for none.
  [[nodiscard]] Index branch_of(int step) const;
  /// The finished tree's leaf with a box.
  [[nodiscard]] Index leaf_of(Index box) const;
  /// "the root", "BDE", "B".
  [[nodiscard]] std::string name_of(const Forest& forest, Index branch) const;
  /// Those that can be tapped: of a node that is divided its own, else all.
  [[nodiscard]] std::vector<Index> candidates(int i) const override;

  struct Where {
    const TreeRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] const Forest& before() const { return run.forest(i); }
    [[nodiscard]] const Forest& after() const { return run.forest(i + 1); }
    [[nodiscard]] std::string name_before(Index branch) const { return run.name_of(before(), branch); }
    /// "box B", "node BDE", "the root".
    [[nodiscard]] std::string beside_name(Index branch) const;
  };

 private:
  void follow_growth();
  void follow_query();

  std::vector<Box2> boxes_;
  NodeKind nodes_ = NodeKind::kAabb;
  Growth::Way way_ = Growth::Way::kDown;
  bool by_hand_ = false, first_ = false, steered_ = false;
  TreeTrace trace_;
  TreeOfBoxes tree_;
  std::vector<Forest> forests_;
  std::vector<QueryState> states_;  // of a query
  QueryResult result_;
  std::optional<TreePairing> pairing_;
  QueryPlaces query_;
  struct Before {
    Forest forest;
    double cost = 0;
  };
  std::optional<Before> before_;  // of an update
  MergedVolumes volumes_;
  std::string_view word_;
};

extern template class FactRun<TreeRun, TreeStep>;

[[nodiscard]] inline const TreeRun& tree_run(const Run& run) { return static_cast<const TreeRun&>(run); }

}  // namespace snug::lesson
