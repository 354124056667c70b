// The tasks "break it": points on which a naive algorithm is wrong in float, and right in double.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "lesson/subjects/cloud/left_outside.hpp"

namespace snug::lesson {

/// Serves welzl_naive and quickhull_rounded.
inline constexpr std::array<std::string_view, 2> kCloudGoals{"wrong_in_float_alone", "hull_wrong_in_float_alone"};

/// What the goal's algorithm leaves outside in each scalar, on the same points: those rounded to float, which double
/// holds as they are.
struct ScalarsCompared {
  bool fits = true;     // whether float can hold the points
  const char* of = "";  // what an ulp is of
  LeftOutside in_float, in_double;
};
[[nodiscard]] ScalarsCompared compare_scalars(std::string_view goal, const AnyPointSet& points, std::uint64_t seed);

/// Whether a point is left outside in float, or a hull dented, and neither in double.
[[nodiscard]] bool breaks(const ScalarsCompared& compared);
/// A sentence about it. name_of: a point's name.
[[nodiscard]] std::string says_of(const ScalarsCompared& compared, const std::function<std::string(Index)>& name_of);

}  // namespace snug::lesson
