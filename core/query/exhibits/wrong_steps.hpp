// The steps of the two tests of boxes that are wrong (wrong_extents_only.hpp, wrong_corners_only.hpp).
#pragma once

#include <string_view>
#include <variant>

#include "trace/fields.hpp"

namespace snug::query {

/// The boxes' AABBs were compared along a coordinate axis.
struct OutlinesCompared {
  static constexpr std::string_view kName = "outlines_compared";
  int axis = 0;
  double least_a = 0, greatest_a = 0, least_b = 0, greatest_b = 0;  // scene units
  bool apart = false;
  SNUG_FIELDS(axis, least_a, greatest_a, least_b, greatest_b, apart);
};

/// A vertex of one box was tested against the other. box: whose vertex, 0 for A; corner: its bits, 1 for +x, 2 for +y,
/// 4 for +z.
struct CornerTried {
  static constexpr std::string_view kName = "corner_tried";
  int box = 0, corner = 0;
  bool inside = false;
  SNUG_FIELDS(box, corner, inside);
};

/// What such a test says in the end, right or wrong.
struct Claimed {
  static constexpr std::string_view kName = "claimed";
  bool overlap = false;
  SNUG_FIELDS(overlap);
};

struct WrongStep {
  using Fact = std::variant<OutlinesCompared, CornerTried, Claimed>;
  int line = 0;
  Fact fact;
};

}  // namespace snug::query
