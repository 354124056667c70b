// How long it takes to build a tree of many boxes, and to refit or rebuild it after they have moved.
#pragma once

#include <optional>

#include "lesson/subjects/tree/tree_merge.hpp"

namespace snug::lesson {

/// How many boxes are timed: those on the stage are too few for a clock.
inline constexpr int kCrowd = 2000;

/// Many small boxes in place of each box, around its centre. The same boxes at other places have the same crowds,
/// moved with them. boxes: at least one.
[[nodiscard]] std::vector<Box2> crowd_of(std::span<const Box2> boxes);

struct TreeTime {
  double cost = 0;           // hierarchy::expected_cost of the tree
  std::optional<double> ns;  // the mean of a few runs; none without a clock. It is no figure, because figures are the
                             // same everywhere
};
/// Builds a tree of such a crowd. method: the name of a build method, but not by_hand.
[[nodiscard]] TreeTime time_of_building(std::string_view method, std::span<const Box2> crowd, Clock clock);
/// Refits a tree that was built of a crowd by surface area, after its boxes have moved. built: where they were.
[[nodiscard]] TreeTime time_of_refitting(std::span<const Box2> built, std::span<const Box2> crowd, Clock clock);

}  // namespace snug::lesson
