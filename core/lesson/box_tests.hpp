// The tests of two boxes that a lesson can show, beside the algorithms that fit a volume to points.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "fit/catalogue.hpp"
#include "lesson/boxes.hpp"

namespace snug::lesson {

/// A lesson's volume where it has two boxes in place of points.
inline constexpr std::string_view kBoxPair = "box_pair";

/// "sat", "sat_all", and the two wrong ones, "extents_only" and "corners_only". They have no fit, record and watch of
/// points.
[[nodiscard]] std::span<const fit::Algorithm> box_tests();
/// Records one of these, or of frustum_tests().
[[nodiscard]] fit::Recording record(const fit::Algorithm& test, const BoxPair& pair);

/// Whether that test says that the boxes overlap.
[[nodiscard]] bool says_overlap(const fit::Algorithm& test, const BoxPair& pair);

/// One of the test's axes, in the order in which it goes through them: those of A's faces, of B's, then the edges'
/// products.
struct AxisName {
  std::string text;  // "A x", "B y", "A x × B z"
  query::AxisKind kind = query::AxisKind::kNone;
  int i = -1, j = -1;
};
/// 4 in 2-D, 15 in 3-D.
[[nodiscard]] std::span<const AxisName> axis_names(int dim);
/// Its place among axis_names(dim), -1 for none.
[[nodiscard]] int axis_index(int dim, const query::SatAxis<double, 3>& axis);
/// Its name there, empty for none.
[[nodiscard]] std::string axis_text(int dim, const query::SatAxis<double, 3>& axis);

}  // namespace snug::lesson
