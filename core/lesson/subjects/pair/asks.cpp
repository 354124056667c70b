// What can be asked about a test of two boxes.
#include <limits>

#include "lesson/decide.hpp"
#include "lesson/formula.hpp"
#include "lesson/subjects/pair/axis_rows.hpp"
#include "lesson/subjects/pair/entries.hpp"

namespace snug::lesson {
namespace {

const query::AxisTested<double, 3>* axis_of(const PairSteps& steps, int i) {
  return std::get_if<query::AxisTested<double, 3>>(&steps[i].step.fact);
}

/// The test's axes, to be chosen in the table as well, and none.
void offer_axes(Asked& asked) {
  for (const AxisName& axis : axis_names(asked.dim)) asked.add_choice(axis.text);
  asked.add_choice("none");
  asked.on_axes = true;
}

}  // namespace

/// The entries of R, row by row.
const char* offer_entries_b(Asked& asked, const Run& run) {
  const int place = axis_index(asked.dim, axis_of(pair_run(run).trace(), asked.fact)->axis);
  if (row_entries(asked.dim, place).rotation_b == 0) return "along a normal of its own face, a radius is a half extent";
  for (int i = 0; i < asked.dim; ++i)
    for (int j = 0; j < asked.dim; ++j) asked.add_choice("R" + std::to_string(i + 1) + std::to_string(j + 1));
  asked.many = true;
  return nullptr;
}

Truth entries_b_truth(const Asked& asked, const Run& run) {
  const int place = axis_index(asked.dim, axis_of(pair_run(run).trace(), asked.fact)->axis);
  const std::uint16_t entries = row_entries(asked.dim, place).rotation_b;
  Truth truth;
  for (int i = 0; i < asked.dim; ++i)
    for (int j = 0; j < asked.dim; ++j)
      if ((entries >> (3 * i + j) & 1) != 0) truth.choices.push_back(asked.dim * i + j);
  truth.happened = choice_words(asked, truth.choices);
  truth.sentence = "r_B = " + plain_formula(row_formulas(asked.dim, place).radius_b).value_or(std::string()) + ".";
  return truth;
}

const char* offer_of_axis(Asked& asked, const Run& run) {
  const auto& fact = pair_run(run).trace()[asked.fact].step.fact;
  if (const auto* axis = std::get_if<query::AxisTested<double, 3>>(&fact)) asked.of = axis_text(asked.dim, axis->axis);
  if (const auto* slab = std::get_if<query::SlabTested>(&fact)) asked.of = axis_name(slab->direction);
  return offer_yes_no(asked, run);
}

const char* offer_radius_b(Asked& asked, const Run& run) {
  const auto& axis = *axis_of(pair_run(run).trace(), asked.fact);
  if (axis.skipped) return "the edges are parallel, so there is no axis";
  if (row_entries(asked.dim, axis_index(asked.dim, axis.axis)).rotation_b == 0)
    return "along a normal of its own face, a radius is a half extent";
  asked.of = axis_text(asked.dim, axis.axis);
  asked.number = true;
  asked.unit = "units";
  return nullptr;
}

/// The trace's lengths are along an axis that need not be a unit one.
Truth radius_b_truth(const Asked& asked, const Run& run) {
  const auto& axis = *axis_of(pair_run(run).trace(), asked.fact);
  const double length = axis.radius_b / axis.length;
  const std::string radius = number_text(length);
  Truth truth{{}, {}, radius, "Along " + axis_text(asked.dim, axis.axis) + ", r_B is " + radius + "."};
  truth.number = length;
  truth.tolerance = asked.question->tolerance;
  return truth;
}

void read_tolerance(TomlTable& table, Question& question) {
  question.tolerance = table.any_number("tolerance", 0);
  if (!(question.tolerance > 0) || std::isinf(question.tolerance)) table.wrong("tolerance", "must be above 0");
}

std::optional<Answer> sum_of_half_extents(const Asked& asked, const Run&) {
  const auto* boxes = as<PairSubject>(*asked.subject);
  if (boxes == nullptr) return std::nullopt;
  const Obb<double, 3>& b = boxes->boxes().boxes[1];
  return TypedNumber{b.half_extents.head(asked.dim).sum()};
}

std::optional<Answer> whole_width(const Asked& asked, const Run& run) {
  return TypedNumber{2 * radius_b_truth(asked, run).number};
}

double separates_margin(const Asked& asked, const Run& run) {
  const auto& axis = *axis_of(pair_run(run).trace(), asked.fact);
  return axis.skipped ? 0 : std::abs(axis.axis.gap) / extent_of(*asked.subject);
}

std::optional<Answer> without_b(const Asked& asked, const Run& run) {
  const auto& axis = *axis_of(pair_run(run).trace(), asked.fact);
  return by_choice(axis.distance > axis.radius_a ? kYes : kNo);
}
std::optional<Answer> with_full_widths(const Asked& asked, const Run& run) {
  const auto& axis = *axis_of(pair_run(run).trace(), asked.fact);
  return by_choice(axis.distance > 2 * (axis.radius_a + axis.radius_b) ? kYes : kNo);
}

Truth separates_truth(const Asked& asked, const Run& run) {
  const auto& axis = *axis_of(pair_run(run).trace(), asked.fact);
  if (axis.skipped) return no("The edges are parallel, so their cross product gives no axis.");
  if (axis.separates) return yes("There is a gap of " + gap_text(axis.axis.gap) + ": this axis separates the boxes.");
  if (!(axis.axis.gap < -axis.doubt)) return no("The projections touch, within rounding error.");
  return no("The projections overlap by " + gap_text(-axis.axis.gap) + ".");
}

Truth slab_truth(const Asked& asked, const Run& run) {
  const auto& slab = *std::get_if<query::SlabTested>(&pair_run(run).trace()[asked.fact].step.fact);
  if (!slab.separates && touch(slab)) return no("The intervals touch, and touching counts as overlapping.");
  if (!slab.separates) return no("The intervals overlap.");
  return yes("The intervals are " + gap_text(slab_gap(slab)) + " apart.");
}

/// How far the intervals are from touching.
double slab_margin(const Asked& asked, const Run& run) {
  const auto& slab = *std::get_if<query::SlabTested>(&pair_run(run).trace()[asked.fact].step.fact);
  return std::abs(slab_gap(slab)) / extent_of(*asked.subject);
}

std::optional<Answer> one_way(const Asked& asked, const Run& run) {
  const auto& slab = *std::get_if<query::SlabTested>(&pair_run(run).trace()[asked.fact].step.fact);
  return by_choice(slab.greatest_a < slab.least_b ? kYes : kNo);
}
/// As if intervals overlapped only where one contains the other.
std::optional<Answer> contained_only(const Asked& asked, const Run& run) {
  const auto& slab = *std::get_if<query::SlabTested>(&pair_run(run).trace()[asked.fact].step.fact);
  const bool in_a = slab.least_a <= slab.least_b && slab.greatest_b <= slab.greatest_a;
  const bool in_b = slab.least_b <= slab.least_a && slab.greatest_a <= slab.greatest_b;
  return by_choice(in_a || in_b ? kNo : kYes);
}

double cores_margin(const Asked& asked, const Run& run) {
  const auto& cores = *std::get_if<query::CoresCompared>(&pair_run(run).trace()[asked.fact].step.fact);
  return std::abs(cores.distance - cores.radii) / extent_of(*asked.subject);
}
std::optional<Answer> without_radii(const Asked& asked, const Run& run) {
  const auto& cores = *std::get_if<query::CoresCompared>(&pair_run(run).trace()[asked.fact].step.fact);
  return by_choice(cores.distance > 0 ? kYes : kNo);
}

Truth cores_truth(const Asked& asked, const Run& run) {
  const auto& cores = *std::get_if<query::CoresCompared>(&pair_run(run).trace()[asked.fact].step.fact);
  const auto [distance, radii] = number_texts_apart(cores.distance, cores.radii);
  const std::string both = distance + (cores.apart ? " is greater than " : " is not greater than ") + radii + ".";
  return cores.apart ? yes(both) : no(both);
}

Truth overlap_truth(const Asked& asked, const Run& run) {
  const auto& end = *std::get_if<OverlapDecided>(&pair_run(run).trace()[asked.fact].step.fact);
  if (end.overlap) return no(overlap_text(pair_run(run).trace().first(static_cast<std::size_t>(asked.fact))));
  return yes("There is a gap of " + gap_text(end.gap) + ".");
}

const char* offer_coordinate_axes(Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  const auto along_coordinate = [](const auto& entry) {
    const auto* slab = std::get_if<query::SlabTested>(&entry.step.fact);
    return slab != nullptr && slab->direction.cwiseAbs().maxCoeff() == 1;
  };
  if (asked.fact == 0 || !std::all_of(steps.begin(), steps.begin() + asked.fact, along_coordinate))
    return "\"first_axis\" can only be asked of a test of intervals along the coordinate axes alone";
  for (int i = 0; i < asked.dim; ++i) asked.add_choice(std::string(1, "xyz"[i]));
  asked.add_choice("none");
  return nullptr;
}

Truth first_axis_truth(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  for (int i = 0; i < asked.fact; ++i) {
    const auto& slab = *std::get_if<query::SlabTested>(&steps[i].step.fact);
    if (!slab.separates) continue;
    const std::string name = axis_name(slab.direction);
    return {{i}, {}, name, "The test meets the first gap along " + name + ", and ends there."};
  }
  return {{asked.dim}, {}, "none", "The intervals overlap along every axis, so there is no gap to meet."};
}

const char* offer_first_axis(Asked& asked, const Run&) {
  offer_axes(asked);
  return nullptr;
}

Truth first_axis_of_test(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  int first = -1;
  for (int i = 0; i < asked.fact && first < 0; ++i)
    if (const auto* axis = axis_of(steps, i); axis != nullptr && axis->separates)
      first = axis_index(asked.dim, axis->axis);
  const auto& result = std::get_if<query::Verdict<double, 3>>(&steps[asked.fact].step.fact)->result;
  if (first < 0 && !result.overlap) first = axis_index(asked.dim, result.axis);
  if (first < 0)
    return {{static_cast<int>(asked.choices.size()) - 1}, {}, "none", "No row shows a gap, so all are tested."};
  const std::string& name = asked.choices[first];
  return {{first}, {}, name, name + " is the first row of the table that shows a gap."};
}

const char* offer_least_penetration(Asked& asked, const Run& run) {
  const auto& result = std::get_if<query::Verdict<double, 3>>(&pair_run(run).trace()[asked.fact].step.fact)->result;
  if (!result.overlap || result.axis.kind == query::AxisKind::kNone)
    return "\"least_penetration\" can only be asked of boxes that overlap, in a test that goes through all axes";
  offer_axes(asked);
  asked.choices.pop_back();
  asked.choice_handles.pop_back();
  return nullptr;
}

/// Every axis whose penetration is least but for rounding is a right answer.
Truth least_penetration_truth(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  const auto& best = std::get_if<query::Verdict<double, 3>>(&steps[asked.fact].step.fact)->result.axis;
  Truth truth;
  for (int i = 0; i < asked.fact; ++i) {
    const auto* axis = axis_of(steps, i);
    if (axis == nullptr || axis->skipped || axis->axis.gap < best.gap - axis->doubt) continue;
    truth.choices.push_back(axis_index(asked.dim, axis->axis));
  }
  truth.happened = axis_text(asked.dim, best);
  truth.sentence = "Along " + truth.happened + " the projections overlap least, by " + gap_text(-best.gap) + ".";
  return truth;
}

const char* offer_tested_axes(Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  std::size_t tested = 0;
  for (int i = 0; i < asked.fact; ++i) tested += axis_of(steps, i) != nullptr;
  if (tested != axis_names(asked.dim).size())
    return "\"which_axis\" can only be asked of a test that goes through all axes";
  offer_axes(asked);
  return nullptr;
}

/// Every axis that separates is a right answer, not just the first; so is one that only exact arithmetic found.
Truth which_axis_truth(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  Truth truth;
  for (int i = 0; i <= asked.fact; ++i) {
    const auto* axis = axis_of(steps, i);
    const auto* verdict = std::get_if<query::Verdict<double, 3>>(&steps[i].step.fact);
    if (axis != nullptr && axis->separates) truth.choices.push_back(axis_index(asked.dim, axis->axis));
    else if (verdict != nullptr && !verdict->result.overlap && truth.choices.empty())
      truth.choices.push_back(axis_index(asked.dim, verdict->result.axis));
  }
  if (truth.choices.empty())
    return {{static_cast<int>(asked.choices.size()) - 1}, {}, "none", "No axis separates the boxes: they overlap."};
  truth.happened = choice_words(asked, truth.choices);
  truth.sentence = truth.choices.size() == 1 ? truth.happened + " is the only axis that separates the boxes."
                                             : "These axes separate the boxes: " + truth.happened + ".";
  return truth;
}

/// The test that came nearest to a tie.
double all_axes_margin(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= asked.fact; ++i)
    if (const auto* axis = axis_of(steps, i); axis != nullptr && !axis->skipped)
      least = std::min(least, std::abs(axis->axis.gap));
  return least / extent_of(*asked.subject);
}

double penetration_margin(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  Scores gaps;
  for (int i = 0; i < asked.fact; ++i)
    if (const auto* axis = axis_of(steps, i); axis != nullptr && !axis->skipped) gaps.add(i, axis->axis.gap);
  return gaps.lead() / extent_of(*asked.subject);
}

double overlap_margin(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < asked.fact; ++i) {
    if (const auto* slab = std::get_if<query::SlabTested>(&steps[i].step.fact))
      least = std::min(least, std::abs(slab_gap(*slab)));
    if (const auto* cores = std::get_if<query::CoresCompared>(&steps[i].step.fact))
      least = std::min(least, std::abs(cores->distance - cores->radii));
  }
  return least / extent_of(*asked.subject);
}

}  // namespace snug::lesson
