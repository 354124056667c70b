// The figures and the proof of a test of two boxes.
#include "lesson/subjects/pair/box_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace snug::lesson {
namespace {

using Axis = query::AxisTested<double, 3>;

Figure length(std::string name, std::string key, double value, const std::string& text, bool known) {
  return {std::move(name), std::move(key), known ? text + " units" : "—", value, "units", known};
}

const query::Verdict<double, 3>* verdict_of(PairSteps steps) {
  return steps.empty() ? nullptr : std::get_if<query::Verdict<double, 3>>(&steps.back().step.fact);
}

/// Whether some axes were too close to call in floating point.
bool looked_closer(PairSteps steps) {
  return std::any_of(steps.begin(), steps.end(),
                     [](const auto& entry) { return std::holds_alternative<query::LookedCloser>(entry.step.fact); });
}

/// What exact arithmetic says to a naive test's row, if it is of one, and how many of its rows are wrong so far.
void add_truths(std::vector<Figure>& figures, const View& view, bool of_row) {
  const PairRun& run = pair_run(view.run());
  if (run.steps() == 0 || run.truth(0) == nullptr) return;
  const RowTruth* last = nullptr;
  int wrong = 0;
  for (int i = 0; i < view.step; ++i)
    if (const auto* row = std::get_if<Axis>(&run.trace()[i].step.fact))
      last = run.truth(i), wrong += is_wrong(*row, *last) ? 1 : 0;
  if (!of_row) last = nullptr;  // the verdict is about all rows, not about the last of them
  figures.push_back(length("Exact separation", "exact_gap", last != nullptr ? last->gap : 0,
                           last != nullptr ? gap_text(last->gap) : "", last != nullptr));
  figures.push_back({"Wrong rows", "wrong_rows", std::to_string(wrong), static_cast<double>(wrong), "rows"});
}

}  // namespace

std::vector<Axis> axes_seen(PairSteps steps) {
  std::vector<Axis> axes;
  for (const auto& entry : steps)
    if (const auto* axis = std::get_if<Axis>(&entry.step.fact)) axes.push_back(*axis);
  return axes;
}

std::optional<Axis> axis_at(PairSteps steps) {
  if (steps.empty()) return std::nullopt;
  const auto& fact = steps.back().step.fact;
  if (const auto* tested = std::get_if<Axis>(&fact)) return *tested;
  const auto* verdict = std::get_if<query::Verdict<double, 3>>(&fact);
  if (verdict == nullptr) return std::nullopt;
  const auto& own = verdict->result.axis;
  for (Axis axis : axes_seen(steps)) {
    if (axis.axis.kind != own.kind || axis.axis.i != own.i || axis.axis.j != own.j) continue;
    axis.axis = own;
    axis.separates = !verdict->result.overlap;
    return axis;
  }
  return std::nullopt;
}

std::vector<Figure> box_figures(const View& view, const BoxPair& pair) {
  const PairSteps steps = pair_run(view.run()).trace();
  if (axes_seen(steps).empty()) return {};
  const int dim = pair.dim;
  const auto tested = axes_seen(steps.first(view.step)).size();
  const std::optional<Axis> at = axis_at(steps.first(view.step));
  const bool any = at && !at->skipped;
  const Axis axis = at.value_or(Axis{});
  const bool apart = any && axis.axis.gap > 0;
  std::vector<Figure> figures{
      {"Axis", "axis", at ? axis_text(dim, axis.axis) : "—", static_cast<double>(axis_index(dim, axis.axis)), "",
       at.has_value()},
      length("Distance along the axis", "distance", axis.distance, length_along(axis, axis.distance), any),
      length("Projected radius r_A", "radius_a", axis.radius_a, length_along(axis, axis.radius_a), any),
      length("Projected radius r_B", "radius_b", axis.radius_b, length_along(axis, axis.radius_b), any),
      length(!any || apart ? "Separation" : "Penetration", "gap", axis.axis.gap, gap_text(std::abs(axis.axis.gap)),
             any),
      {"Axes tested", "tests", std::to_string(tested) + " of " + std::to_string(axis_names(dim).size()),
       static_cast<double>(tested), "axes"}};
  for (Figure& figure : figures) figure.of_step = is_along_axis(figure.key);
  if (pair.dim == 3) {
    const bool crossed = at && at->axis.kind == query::AxisKind::kEdgeEdge;
    figures.push_back(
        {"Length of the cross product", "length", crossed ? number_text(axis.length) : "—", axis.length, "", crossed});
  }
  add_truths(figures, view, at.has_value());
  return figures;
}

bool is_along_axis(std::string_view key) {
  return key == "distance" || key == "radius_a" || key == "radius_b" || key == "gap" || key == "length";
}

std::vector<Proof> box_proofs(const View& view, const BoxPair& pair) {
  if (!view.at_end()) return {};
  const PairSteps steps = pair_run(view.run()).trace();
  const auto* verdict = verdict_of(steps);
  const bool naive = is_naive(view.method().name);
  const bool right = overlap_exactly(view.method().name, pair);
  const bool says = says_overlap(view.method().name, pair);
  const std::string said = says ? "this test says: the boxes overlap" : "this test says: the boxes are apart";
  if (verdict == nullptr || naive || says != right)
    return {{said, true, true},
            {says == right
                 ? naive ? "right here: exact arithmetic says the same" : "right here: the separating axes say the same"
             : naive ? "wrong: exact arithmetic says otherwise"
                     : "wrong: the separating axes say otherwise",
             says == right, true}};
  const bool exactly = looked_closer(steps);
  if (says)
    return {{"none of the " + std::to_string(axis_names(pair.dim).size()) + " axes separates the boxes" +
                 (exactly ? ", in exact arithmetic" : ""),
             true, true}};
  return {
      {exactly ? "the gap is proved in exact arithmetic" : "the gap is larger than any rounding error", true, true}};
}

}  // namespace snug::lesson
