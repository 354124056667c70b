// The steps of building, refitting and traversing a tree.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug::hierarchy {

/// A node's bodies were divided: left and right are how many went to each side. axis: kNoIndex if all centres are in
/// one place, and they were divided by index. position: the first centre on the right (median) or the border between
/// bins, in scene units. cost: by the surface-area heuristic, in tests of a body; 0 for the median.
struct SplitChosen {
  static constexpr std::string_view kName = "split_chosen";
  Index node = 0;
  int axis = kNoIndex;
  double position = 0;
  Index left = 0, right = 0;
  double cost = 0;
  SNUG_FIELDS(node, axis, position, left, right, cost);
};

/// The surface-area heuristic priced every border between bins, for a node. axis and border: the cheapest; border is
/// counted from 1. low and high: of the node's centres, for each axis, in scene units. costs: for each axis, one for
/// each border, in tests of a body; infinite along an axis where the centres do not spread.
struct SplitsPriced {
  static constexpr std::string_view kName = "splits_priced";
  Index node = 0;
  int axis = kNoIndex, border = 0;
  std::vector<double> low, high, costs;
  [[nodiscard]] int borders() const { return static_cast<int>(costs.size() / low.size()); }
  [[nodiscard]] double cost_at(int along, int at) const { return costs[along * borders() + at - 1]; }
  [[nodiscard]] double position(int along, int at) const {
    return low[along] + at * (high[along] - low[along]) / (borders() + 1);
  }
  SNUG_FIELDS(node, axis, border, low, high, costs);
};

/// A node became a leaf. bodies: how many it has.
struct LeafMade {
  static constexpr std::string_view kName = "leaf_made";
  Index node = 0;
  Index bodies = 0;
  SNUG_FIELDS(node, bodies);
};

/// Two groups were merged. Group i is body i if i is below the number n of bodies; merged groups are numbered from n
/// on. area: half of the surface area (in the plane: of the perimeter) of the axis-aligned box around both, in scene
/// units.
struct NodesMerged {
  static constexpr std::string_view kName = "nodes_merged";
  Index merged = 0;
  Index left = 0, right = 0;
  double area = 0;
  SNUG_FIELDS(merged, left, right, area);
};

/// A body was inserted beside a group, and both are now children of the new group `made`. For the first body both are
/// kNoIndex. Groups are numbered as above. growth: the sum of the half surface areas' growth along the path, the new
/// group's included, in scene units squared (in the plane: units).
struct BodyInserted {
  static constexpr std::string_view kName = "body_inserted";
  Index body = 0;
  Index beside = kNoIndex, made = kNoIndex;
  double growth = 0;
  SNUG_FIELDS(body, beside, made, growth);
};

/// One child of a group and a grandchild below its other child changed places, which made that other child smaller.
struct Rotated {
  static constexpr std::string_view kName = "rotated";
  Index group = 0;
  Index down = 0, up = 0;  // the former child, the former grandchild
  double gain = 0;         // half surface
  SNUG_FIELDS(group, down, up, gain);
};

/// A node got its volume: the merged volumes of its bodies or of both children.
struct VolumeMade {
  static constexpr std::string_view kName = "volume_made";
  Index node = 0;
  SNUG_FIELDS(node);
};

/// What to do with a node or a body after the test of its volume, and with everything below it.
enum class Answer : std::uint8_t { kPrune, kDescend, kAccept };

/// A node's volume was tested.
struct NodeVisited {
  static constexpr std::string_view kName = "node_visited";
  Index node = 0;
  Answer answer = Answer::kPrune;
  SNUG_FIELDS(node, answer);
};

/// A body's own volume was tested.
struct BodyTested {
  static constexpr std::string_view kName = "body_tested";
  Index body = 0;
  Answer answer = Answer::kPrune;
  SNUG_FIELDS(body, answer);
};

/// A node of one tree was tested against a node of another; if bodies is set, a body against a body.
struct PairTested {
  static constexpr std::string_view kName = "pair_tested";
  Index a = 0, b = 0;
  bool bodies = false;
  bool overlap = false;
  SNUG_FIELDS(a, b, bodies, overlap);
};

/// The end: how many nodes were built, or how many a traversal visited.
struct Done {
  static constexpr std::string_view kName = "done";
  std::int64_t nodes = 0;
  std::int64_t volume_tests = 0;
  SNUG_FIELDS(nodes, volume_tests);
};

struct Step {
  using Fact = std::variant<SplitsPriced, SplitChosen, LeafMade, NodesMerged, BodyInserted, Rotated, VolumeMade,
                            NodeVisited, BodyTested, PairTested, Done>;
  int line = 0;  // the line in the algorithm's pseudocode, counted from 0
  Fact fact;
};

}  // namespace snug::hierarchy
