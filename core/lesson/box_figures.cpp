// The figures and the proof of a test of two boxes.
#include "lesson/box_figures.hpp"

#include "lesson/ask.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/methods.hpp"

namespace snug::lesson {
namespace {

using Axis = query::AxisTested<double, 3>;

Figure length(std::string name, std::string key, double value, bool known) {
  return {std::move(name), std::move(key), known ? number_text(value) + " units" : "—", value, "units", known};
}

const query::Verdict<double, 3>* verdict_of(const RunView& run) {
  const auto& steps = run.recording->steps;
  return steps.empty() ? nullptr : std::get_if<query::Verdict<double, 3>>(&steps.back().step.fact);
}

}  // namespace

std::vector<Axis> axes_seen(std::span<const Recorder<fit::Step3>::Entry> steps) {
  std::vector<Axis> axes;
  for (const auto& entry : steps)
    if (const auto* axis = std::get_if<Axis>(&entry.step.fact)) axes.push_back(*axis);
  return axes;
}

std::vector<Figure> box_figures(const RunView& run) {
  const std::span<const Recorder<fit::Step3>::Entry> steps(run.recording->steps);
  const std::vector<Axis> axes = axes_seen(steps.first(run.step));
  const auto all = axes_seen(steps).size();
  if (all == 0) return {};
  const bool any = !axes.empty() && !axes.back().skipped;
  const Axis axis = any ? axes.back() : Axis{};
  const std::string text = std::to_string(axes.size()) + " of " + std::to_string(axis_names(run.boxes->dim).size());
  return {length("Distance of the centres", "distance", axis.distance, any),
          length("Radius of A", "radius_a", axis.radius_a, any),
          length("Radius of B", "radius_b", axis.radius_b, any),
          length(axis.axis.gap > 0 ? "Gap" : "Gap (overlap)", "gap", axis.axis.gap, any),
          {"Axes tested", "tests", text, static_cast<double>(axes.size()), "axes"}};
}

std::vector<Proof> box_proofs(const RunView& run) {
  const auto* verdict = verdict_of(run);
  if (run.step < static_cast<int>(run.recording->steps.size())) return {};
  const bool right = says_overlap(*find_method(kBoxPair, "sat"), *run.boxes);
  const bool says = says_overlap(*run.algorithm, *run.boxes);
  const std::string said = says ? "it says: the boxes overlap" : "it says: the boxes are apart";
  if (verdict == nullptr || says != right)
    return {{said, true, true},
            {says == right ? "right here: the separating axes agree" : "wrong: the separating axes say otherwise",
             says == right, true}};
  if (says)
    return {{"no axis of the " + std::to_string(axis_names(run.boxes->dim).size()) + " separates them", true, true}};
  return {{"the gap is larger than all rounding", true, true}};
}

}  // namespace snug::lesson
