// The steps of the two tests of boxes that are wrong (wrong_extents_only.hpp, wrong_corners_only.hpp).
#pragma once

#include <string_view>
#include <variant>

#include "geometry/obb.hpp"
#include "geometry/vector.hpp"

namespace snug::query {

/// The boxes' upright outlines were compared along a coordinate axis.
struct OutlinesCompared {
  static constexpr std::string_view kName = "outlines_compared";
  int axis = 0;
  double least_a = 0, greatest_a = 0, least_b = 0, greatest_b = 0;  // scene units
  bool apart = false;
  void fields(auto&& see) const {
    see("axis", axis), see("least_a", least_a), see("greatest_a", greatest_a), see("least_b", least_b);
    see("greatest_b", greatest_b), see("apart", apart);
  }
};

/// A corner of one box was held against the other. box: whose corner, 0 for A; corner: its bits, 1 for +x, 2 for +y,
/// 4 for +z.
struct CornerTried {
  static constexpr std::string_view kName = "corner_tried";
  int box = 0, corner = 0;
  bool inside = false;
  void fields(auto&& see) const { see("box", box), see("corner", corner), see("inside", inside); }
};

/// What such a test says in the end, right or wrong.
struct Claimed {
  static constexpr std::string_view kName = "claimed";
  bool overlap = false;
  void fields(auto&& see) const { see("overlap", overlap); }
};

struct WrongStep {
  using Fact = std::variant<OutlinesCompared, CornerTried, Claimed>;
  int line = 0;
  Fact fact;
};

/// Two boxes on which a wrong test disagrees with the right one.
template <class Scalar, int Dim>
struct CounterExample {
  Obb<Scalar, Dim> a, b;
  int tries = 0;  // how many pairs were tried before
};

}  // namespace snug::query
