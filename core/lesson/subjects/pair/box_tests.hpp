// The tests of two boxes that a lesson can show, and their steps.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lesson/boxes.hpp"
#include "query/sat_steps.hpp"
#include "query/wrong_steps.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// A step of any of the tests, in 3-D: in 2-D z is 0, and the third axis z.
struct PairStep {
  int line = 0;  // of the test's pseudocode, counted from 0
  std::variant<query::FramesRelated<double, 3>, query::AxisTested<double, 3>, query::LookedCloser,
               query::Verdict<double, 3>, query::OutlinesCompared, query::CornerTried, query::Claimed>
      fact;
};
using PairTrace = std::vector<Recorder<PairStep>::Entry>;
using PairSteps = std::span<const Recorder<PairStep>::Entry>;

/// "sat", "sat_all", and the two wrong ones, "extents_only" and "corners_only".
[[nodiscard]] std::span<const Method> box_tests();
[[nodiscard]] PairTrace record(std::string_view test, const BoxPair& pair);

/// Whether that test says that the boxes overlap.
[[nodiscard]] bool says_overlap(std::string_view test, const BoxPair& pair);

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
