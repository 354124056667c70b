#include "lesson/subjects/pair/naive_tests.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/pair.hpp"
#include "query/exhibits/naive_sat.hpp"
#include "query/overlap/exact_gap.hpp"
#include "query/overlap/obb_sat.hpp"

namespace snug::lesson {
namespace {

using query::Guard;

constexpr std::string_view kEricsonOnBoxes = "C. Ericson, Real-Time Collision Detection, 2005, 4.4.1";

constexpr Method naive(std::string_view name, std::string_view title, std::span<const std::string_view> pseudocode) {
  return {.volume = kBoxPair,
          .name = name,
          .title = title,
          .source = kEricsonOnBoxes,
          .pseudocode = pseudocode,
          .plane = false};
}

constexpr std::array kNaive{
    naive("no_epsilon", "No epsilon (naive)", query::kNaivePseudocode),
    naive("no_epsilon_float", "No epsilon, in float (naive)", query::kNaivePseudocode),
    naive("epsilon_on_r", "Epsilon on R (naive)", query::kNaiveOnRPseudocode),
    naive("epsilon_on_r_float", "Epsilon on R, in float (naive)", query::kNaiveOnRPseudocode),
    naive("absolute_epsilon", "Absolute epsilon (naive)", query::kNaiveAbsolutePseudocode),
    naive("absolute_epsilon_float", "Absolute epsilon, in float (naive)", query::kNaiveAbsolutePseudocode),
    naive("relative_epsilon", "Relative epsilon (naive)", query::kNaiveRelativePseudocode),
    naive("relative_epsilon_float", "Relative epsilon, in float (naive)", query::kNaiveRelativePseudocode),
    naive("faces_only", "Faces only (naive)", query::kFacesOnlyPseudocode),
};

bool in_float(std::string_view test) { return test.ends_with("_float"); }

Guard guard_of(std::string_view test) {
  if (test.starts_with("epsilon_on_r")) return Guard::kOnR;
  if (test.starts_with("absolute")) return Guard::kAbsolute;
  return test.starts_with("relative") ? Guard::kRelative : Guard::kNone;
}

/// Calls a function with both boxes in the test's own kind of number.
template <class Call>
auto in_scalar(std::string_view test, const BoxPair& pair, Call call) {
  if (!pair.in_float && !in_float(test)) return call(pair.boxes[0], pair.boxes[1]);
  return call(converted<float, 3>(pair.boxes[0]), converted<float, 3>(pair.boxes[1]));
}

/// What an axis really shows, of boxes in Scalar.
template <class Scalar>
RowTruth truth_along(const Obb<Scalar, 3>& a, const Obb<Scalar, 3>& b, int place) {
  const double gap = query::exact_gap(a, b, place);
  const Scalar size = (b.center - a.center).template lpNorm<1>() + a.half_extents.sum() + b.half_extents.sum();
  const Scalar ulp = std::nextafter(size, std::numeric_limits<Scalar>::infinity()) - size;
  return {gap > 0, gap, gap / static_cast<double>(ulp)};
}

}  // namespace

std::span<const Method> naive_tests() { return kNaive; }
bool is_naive(std::string_view test) { return find_method(kNaive, test) != nullptr; }

bool run_naive(std::string_view test, const BoxPair& pair, RecordPair& observe) {
  return in_scalar(test, pair, [&](const auto& a, const auto& b) {
    return test == "faces_only" ? query::faces_only(a, b, observe) : query::naive_sat(a, b, guard_of(test), observe);
  });
}

bool overlap_exactly(std::string_view test, const BoxPair& pair) {
  return in_scalar(test, pair, [](const auto& a, const auto& b) { return query::obb_sat(a, b).overlap; });
}

std::vector<RowTruth> row_truths(std::string_view test, const BoxPair& pair, PairSteps trace) {
  if (!is_naive(test)) return {};
  std::vector<RowTruth> truths(trace.size());
  for (std::size_t i = 0; i < trace.size(); ++i)
    if (const auto* row = std::get_if<query::AxisTested<double, 3>>(&trace[i].step.fact))
      truths[i] = in_scalar(test, pair,
                            [&](const auto& a, const auto& b) { return truth_along(a, b, axis_index(3, row->axis)); });
    else
      truths[i].separates =
          std::holds_alternative<query::Verdict<double, 3>>(trace[i].step.fact) && !overlap_exactly(test, pair);
  return truths;
}

bool is_wrong(const query::AxisTested<double, 3>& row, const RowTruth& truth) {
  return row.separates != truth.separates;
}

std::string truth_text(const RowTruth& truth) {
  if (truth.gap == 0) return "in exact arithmetic the projections touch";
  return (truth.gap > 0 ? "in exact arithmetic there is a gap of "
                        : "in exact arithmetic the projections overlap by ") +
         gap_text(std::abs(truth.gap)) + " (" + number_text(std::abs(truth.ulps), 2) + " ulps)";
}

}  // namespace snug::lesson
