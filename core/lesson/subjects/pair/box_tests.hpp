// The tests of two boxes that a lesson can show, and their steps.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/convert.hpp"
#include "lesson/boxes.hpp"
#include "query/distance/gjk.hpp"
#include "query/exhibits/wrong_steps.hpp"
#include "query/overlap/overlap_steps.hpp"
#include "query/overlap/sat_steps.hpp"
#include "trace/fields.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The end of a test of two volumes that has no such fact itself. direction: the separating axis, unit, from A towards
/// B; zero if they overlap. gap: along that axis, scene units; distance: between the volumes, below 0 if the test does
/// not find it.
struct OverlapDecided {
  static constexpr std::string_view kName = "overlap_decided";
  bool overlap = false;
  double gap = 0, distance = -1;
  Vector<double, 3> direction = Vector<double, 3>::Zero();
  SNUG_FIELDS(overlap, gap, distance, direction);
};

/// A step of any of the tests, in 3-D; from 2-D it has z = 0, and the third axis is z.
struct PairStep {
  int line = 0;  // of the test's pseudocode, counted from 0
  std::variant<query::FramesRelated<double, 3>, query::AxisTested<double, 3>, query::LookedCloser,
               query::Verdict<double, 3>, query::OutlinesCompared, query::CornerTried, query::Claimed,
               query::SlabTested, query::CoresCompared, query::NearestFound, query::SupportFound, query::DigitsDoubled,
               query::DistanceFound, OverlapDecided>
      fact;
};
using PairTrace = std::vector<Recorder<PairStep>::Entry>;
using PairSteps = std::span<const Recorder<PairStep>::Entry>;

/// Keeps the steps of a test, in 3-D.
struct RecordPair {
  PairTrace trace;
  OperationCounts counts{};
  int gjk_line = 0;  // the line where GJK's pseudocode begins
  void operator()(const query::GjkStep& step) { keep(step.line + gjk_line, step.fact); }
  void operator()(const auto& step) { keep(step.line, step.fact); }
  void count(Operation operation, std::int64_t n) { counts[static_cast<std::size_t>(operation)] += n; }
  template <class... Facts>
  void keep(int line, const std::variant<Facts...>& fact) {
    std::visit([&](const auto& own) { trace.push_back({{line, in_space(own)}, counts}); }, fact);
  }

 private:
  template <class Plain>
  static const Plain& in_space(const Plain& fact) {
    return fact;
  }
  template <template <class, int> class Fact, class Scalar, int Dim>
  static Fact<double, 3> in_space(const Fact<Scalar, Dim>& fact) {
    return converted<double, 3>(fact);
  }
};

/// "sat", "sat_all", the two wrong ones, "extents_only" and "corners_only", and the naive ones (naive_tests.hpp).
[[nodiscard]] std::span<const Method> box_tests();
[[nodiscard]] PairTrace record(std::string_view test, const BoxPair& pair);

/// Whether that test says that the boxes overlap.
[[nodiscard]] bool says_overlap(std::string_view test, const BoxPair& pair);

/// One of the test's axes, in the order in which they are tested: those of A's faces, of B's faces, then the cross
/// products of edges.
struct AxisName {
  std::string text;  // "A x", "B y", "A x × B z"
  query::AxisKind kind = query::AxisKind::kNone;
  int i = -1, j = -1;
};
/// 4 in 2-D, 15 in 3-D.
[[nodiscard]] std::span<const AxisName> axis_names(int dim);
/// How a length along an axis is written everywhere, so that it shows whether there is a gap.
[[nodiscard]] std::string length_along(const query::AxisTested<double, 3>& axis, double length);
/// The axis's index in axis_names(dim), -1 for none.
[[nodiscard]] int axis_index(int dim, const query::SatAxis<double, 3>& axis);
/// The axis's name there, empty for none.
[[nodiscard]] std::string axis_text(int dim, const query::SatAxis<double, 3>& axis);

}  // namespace snug::lesson
