// The steps of the two tests of boxes that are wrong (wrong_extents_only.hpp, wrong_corners_only.hpp).
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <variant>

namespace snug::query {

/// The boxes' AABBs were compared along a coordinate axis.
struct OutlinesCompared {
  static constexpr std::string_view kName = "outlines_compared";
  int axis = 0;
  double least_a = 0, greatest_a = 0, least_b = 0, greatest_b = 0;  // scene units
  bool apart = false;
  static constexpr std::array<std::string_view, 6> kFields{"axis",    "least_a",    "greatest_a",
                                                           "least_b", "greatest_b", "apart"};
  static auto tie(auto& own) {
    return std::tie(own.axis, own.least_a, own.greatest_a, own.least_b, own.greatest_b, own.apart);
  }
};

/// A vertex of one box was tested against the other. box: whose vertex, 0 for A; corner: its bits, 1 for +x, 2 for +y,
/// 4 for +z.
struct CornerTried {
  static constexpr std::string_view kName = "corner_tried";
  int box = 0, corner = 0;
  bool inside = false;
  static constexpr std::array<std::string_view, 3> kFields{"box", "corner", "inside"};
  static auto tie(auto& own) { return std::tie(own.box, own.corner, own.inside); }
};

/// What such a test says in the end, right or wrong.
struct Claimed {
  static constexpr std::string_view kName = "claimed";
  bool overlap = false;
  static constexpr std::array<std::string_view, 1> kFields{"overlap"};
  static auto tie(auto& own) { return std::tie(own.overlap); }
};

struct WrongStep {
  using Fact = std::variant<OutlinesCompared, CornerTried, Claimed>;
  int line = 0;
  Fact fact;
};

}  // namespace snug::query
