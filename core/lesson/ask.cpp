#include "lesson/ask.hpp"

#include <algorithm>

#include "geometry/tolerance.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/figures.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/passes.hpp"
#include "lesson/scene_figures.hpp"
#include "lesson/scene_runs.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;
using Asks = Question::Asks;
using Kind = Answer::Kind;

/// What is the case: the right choices and points, in few words and in a sentence.
struct Truth {
  std::vector<int> choices;
  std::vector<Index> points;
  std::string happened;
  std::string sentence;
};

bool contains(const auto& values, int value) { return std::find(values.begin(), values.end(), value) != values.end(); }

std::string name(const Asked& asked, Index point) {
  return asked.boxes ? place_name(asked.dim, point, asked.frustum) : point_name(point);
}

/// "P3", "P3 and P8", "P1, P3 and P8"
std::string names(const Asked& asked, const std::vector<Index>& points) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i + 1 == points.size() ? " and " : ", ";
    text += name(asked, points[i]);
  }
  return text;
}

/// What a step does with the points that it names, in the present tense; plural: of them.
struct Predicate {
  bool plural;
  std::string ball;  // "circle", "sphere"
  std::string operator()(const ExtremesFound<double, 3>&) const { return "reach farthest along the axes"; }
  std::string operator()(const PairChosen&) const { return plural ? "are chosen" : "is chosen"; }
  std::string operator()(const FarthestFound&) const { return "is the farthest"; }
  std::string operator()(const PointExamined&) const { return "is tested against the " + ball; }
  std::string operator()(const BallGrown<double, 3>&) const { return "lies outside, and the " + ball + " grows to it"; }
  std::string operator()(const MovedToFront&) const { return "moves to the front"; }
  std::string operator()(const SupportReplaced&) const { return "enters the support set"; }
  std::string operator()(const RadiusChecked&) const { return "is the farthest from the centre"; }
  std::string operator()(const BoundaryForced&) const {
    return "lies outside, so the next " + ball + " passes through it";
  }
  std::string operator()(const CandidateTried<double, 3>& fact) const {
    return fact.outside != kNoIndex ? "lies outside" : plural ? "are tried" : "is tried";
  }
  std::string operator()(const ExtentsFound<double, 3>&) const { return "reach farthest along the box's axes"; }
  std::string operator()(const BallFound<double, 3>&) const {
    return (plural ? "support the " : "supports the ") + ball;
  }
  std::string operator()(const HullFound&) const { return "are the vertices of the hull"; }
  std::string operator()(const PointsChosen&) const { return plural ? "are chosen" : "is chosen"; }
  std::string operator()(const RectangleFound<double, 3>&) const {
    return "are the ends of the edge that the rectangle lies on";
  }
  std::string operator()(const EdgeSearched&) const { return "are the ends of the edge"; }
  std::string operator()(const BoxWidened&) const { return "widens the box"; }
  std::string operator()(const LineFound&) const {
    return plural ? "are farthest from the line" : "is farthest from the line";
  }
  std::string operator()(const EndPulledIn&) const { return "touches the cap"; }
  std::string operator()(const ThicknessFound&) const { return plural ? "set the radius" : "sets the radius"; }
  std::string operator()(const SidePulledIn&) const { return "touches the side"; }
  std::string operator()(const CornerMovedOut&) const { return "lies outside, past a corner"; }
  std::string operator()(const SlabFound&) const {
    return plural ? "reach farthest along the axis" : "reaches farthest along the axis";
  }
  std::string operator()(const SimplexChosen&) const { return "are the vertices of the first hull"; }
  std::string operator()(const FlatFound&) const { return plural ? "span all points" : "is where all points are"; }
  std::string operator()(const EyeChosen&) const { return "is farthest from the facet"; }
  std::string operator()(const EdgeSplit&) const { return "splits the edge"; }
  std::string operator()(const HorizonFound&) const { return "are on the horizon"; }
  std::string operator()(const query::CornerTried& fact) const {
    return fact.inside ? "lies inside the other box" : "lies outside the other box";
  }
  std::string operator()(const query::PlaneTested<double, 3>&) const { return "are the p- and the n-vertex"; }
  std::string operator()(const query::CornerTested<double, 3>&) const { return "is tested against the frustum"; }
  std::string operator()(const query::AxisTested<double, 3>&) const {
    return std::string(plural ? "come" : "comes") + " nearest to A along this axis";
  }
  std::string operator()(const auto&) const { return (plural ? "support the " : "supports the ") + ball; }
};

Truth point_truth(const Asked& asked, const Step3& step) {
  Truth truth;
  truth.points = points_named(step, asked.dim);
  truth.happened = names(asked, truth.points);
  const Predicate predicate{truth.points.size() > 1, ball_word(asked.dim)};
  truth.sentence = truth.happened + " " + std::visit(predicate, step.fact) + ".";
  return truth;
}

Truth axis_truth(const Asked& asked, const PairChosen& pair) {
  const std::string& choice = asked.choices[pair.axis];
  const std::string sentence = names(asked, {pair.a, pair.b}) + ", " + choice + ", lie farthest apart.";
  return {{pair.axis}, {pair.a, pair.b}, choice, sentence};
}

/// Whether a radius grew by more than the last digits that a check of the result may widen it by.
bool grew(double before, double after) {
  return after - before > tolerance::kBoundaryRoundoffs * tolerance::kRoundoff<double> * after;
}

Truth grows_truth(const Asked& asked, Trace trace) {
  const auto size = [&](int steps) { return steps == 0 ? 0.0 : fit::size_of(trace[steps - 1].step.volume, asked.dim); };
  const double before = size(asked.step);
  const double after = size(asked.until);
  if (grew(before, after))
    return {{0}, {}, "yes", "The radius grows from " + number_text(before) + " to " + number_text(after) + "."};
  if (grew(after, before))
    return {{1}, {}, "no", "The radius shrinks from " + number_text(before) + " to " + number_text(after) + "."};
  return {{1}, {}, "no", "The radius stays " + number_text(before) + "."};
}

Truth leaves_truth(const Asked& asked, Trace trace) {
  const std::vector<Index> after = support_after(trace, asked.until);
  Truth truth;
  for (std::size_t i = 1; i < asked.choices.size(); ++i) {
    if (contains(after, asked.choice_points[i])) continue;
    truth.choices.push_back(static_cast<int>(i));
    truth.points.push_back(asked.choice_points[i]);
  }
  if (truth.choices.empty()) return {{0}, {}, "none", "No point left the support set."};
  truth.happened = names(asked, truth.points);
  truth.sentence = truth.happened + " left the support set.";
  return truth;
}

/// "It ends at 0.9918, smaller than the best before, 0.9920."
std::string pass_sentence(double radius, double best, bool better) {
  const auto [own, before] = number_texts_apart(radius, best);
  if (own == before) return "It ends at " + own + ", as large as the best before, but for rounding.";
  return "It ends at " + own + (better ? ", smaller" : ", larger") + " than the best before, " + before + ".";
}

Truth better_truth(const Asked& asked, Trace trace) {
  const Step3& step = trace[asked.fact].step;
  const auto* pass = std::get_if<PassJudged<double, 3>>(&step.fact);
  const auto* tried = std::get_if<CandidateTried<double, 3>>(&step.fact);
  const bool better = pass != nullptr ? pass->better : tried->verdict == CandidateTried<double, 3>::Verdict::kKept;
  const std::string happened = better ? "yes" : "no";
  if (const auto best = best_before(trace, asked.fact + 1))
    return {{better ? 0 : 1}, {}, happened, pass_sentence(fit::size_of(step.volume, asked.dim), *best, better)};
  if (better) return {{0}, {}, "yes", "It is the smallest so far, and is kept."};
  if (tried != nullptr && tried->outside != kNoIndex)
    return {{1}, {}, "no", point_name(tried->outside) + " lies outside, so it is not kept."};
  return {{1}, {}, "no", "It is no smaller than the best so far."};
}

Truth holds_truth(const Asked& asked, const Finished& finished) {
  const auto n = static_cast<int>(finished.support.size());
  const std::string count = std::to_string(n);
  const std::vector<Index>& points = finished.support;
  return {{n - 1},
          points,
          count,
          names(asked, points) + (n == 1 ? " supports" : " support") + " the " + ball_word(asked.dim) + "."};
}

Truth separates_truth(const query::AxisTested<double, 3>& axis) {
  if (axis.skipped) return {{1}, {}, "no", "The edges are parallel, so their cross product gives no axis."};
  if (axis.separates)
    return {{0}, {}, "yes", "There is a gap of " + number_text(axis.axis.gap) + ": this axis separates the boxes."};
  if (!(axis.axis.gap < -axis.doubt)) return {{1}, {}, "no", "The projections touch, as far as rounded numbers tell."};
  return {{1}, {}, "no", "The projections overlap by " + number_text(-axis.axis.gap) + "."};
}

/// Every axis that separates is a right answer, not just the first; so is one that only exact arithmetic found.
Truth which_axis_truth(const Asked& asked, Trace trace) {
  Truth truth;
  for (int i = 0; i <= asked.fact; ++i) {
    const auto* axis = std::get_if<query::AxisTested<double, 3>>(&trace[i].step.fact);
    const auto* verdict = std::get_if<query::Verdict<double, 3>>(&trace[i].step.fact);
    if (axis != nullptr && axis->separates) truth.choices.push_back(axis_index(asked.dim, axis->axis));
    else if (verdict != nullptr && !verdict->result.overlap && truth.choices.empty())
      truth.choices.push_back(axis_index(asked.dim, verdict->result.axis));
    else continue;
    truth.happened += (truth.happened.empty() ? "" : ", ") + asked.choices[truth.choices.back()];
  }
  if (truth.choices.empty())
    return {{static_cast<int>(asked.choices.size()) - 1}, {}, "none", "No axis separates the boxes: they overlap."};
  truth.sentence = truth.choices.size() == 1 ? truth.happened + " is the only axis that separates the boxes."
                                             : "These axes separate the boxes: " + truth.happened + ".";
  return truth;
}

/// Every corner that is as far is right.
Truth vertex_truth(const Asked& asked, const query::PlaneTested<double, 3>& tested, bool along) {
  Truth truth;
  const int corners = along ? tested.p_corners : tested.n_corners;
  for (int corner = 0; corner < 1 << asked.dim; ++corner)
    if ((corners >> corner & 1) != 0) {
      truth.choices.push_back(corner);
      truth.points.push_back(index_of(asked.dim, {Place::Kind::kCorner, 0, corner}));
    }
  truth.happened = names(asked, truth.points);
  truth.sentence = truth.happened + (truth.points.size() > 1 ? " lie" : " lies") + " farthest " +
                   (along ? "along" : "against") + " the normal of the " + plane_name(asked.dim, tested.plane) +
                   " plane.";
  return truth;
}

Truth culling_truth(query::Culling culling, std::string sentence) {
  const auto choice = static_cast<std::size_t>(culling);
  return {{static_cast<int>(choice)}, {}, std::string(query::kCullingNames[choice]), std::move(sentence)};
}

Truth plane_side_truth(const Asked& asked, const query::PlaneTested<double, 3>& tested) {
  const std::string plane = " the " + plane_name(asked.dim, tested.plane) + " plane";
  switch (tested.side) {
    case query::Culling::kOutside:
      return culling_truth(tested.side, "Even the n-vertex is outside" + plane + ", so the whole box is.");
    case query::Culling::kInside:
      return culling_truth(tested.side, "Even the p-vertex is inside" + plane + ", so the whole box is.");
    case query::Culling::kIntersecting: break;
  }
  return culling_truth(tested.side,
                       "The p-vertex is outside" + plane + " and the n-vertex is not: the box crosses it.");
}

Truth verdict_truth(const Asked& asked, const query::CullResult& result) {
  if (result.rejected_by >= 0)
    return culling_truth(result.verdict,
                         "The whole box is outside the " + plane_name(asked.dim, result.rejected_by) + " plane.");
  if (result.crossing != 0)
    return culling_truth(result.verdict,
                         "The box crosses " + plane_names(asked.dim, result.crossing) + " and is wholly outside none.");
  return culling_truth(result.verdict, "This test says " +
                                           std::string(query::kCullingNames[static_cast<std::size_t>(result.verdict)]) +
                                           ".");
}

/// The range that the figure lies in.
Truth figure_truth(const Asked& asked, const FrameTaken& frame) {
  const Question& question = *asked.question;
  const double value = figure_of(frame, question.figure);
  const auto range = std::lower_bound(question.bounds.begin(), question.bounds.end(), value) - question.bounds.begin();
  const std::string text = scene_figure_text(question.figure, value);
  return {{static_cast<int>(range)}, {}, text, "It is " + text + "."};
}

Truth truth_of(const Asked& asked, Trace trace) {
  const Step3& step = trace[static_cast<std::size_t>(asked.fact)].step;
  const Question& question = *asked.question;
  switch (question.asks) {
    case Asks::kPoint: return point_truth(asked, step);
    case Asks::kAxis: return axis_truth(asked, *std::get_if<PairChosen>(&step.fact));
    case Asks::kGrows: return grows_truth(asked, trace);
    case Asks::kLeaves: return leaves_truth(asked, trace);
    case Asks::kBetter: return better_truth(asked, trace);
    case Asks::kHolds: return holds_truth(asked, *std::get_if<Finished>(&step.fact));
    case Asks::kSeparates: return separates_truth(*std::get_if<query::AxisTested<double, 3>>(&step.fact));
    case Asks::kWhichAxis: return which_axis_truth(asked, trace);
    case Asks::kPVertex:
    case Asks::kNVertex:
      return vertex_truth(asked, *std::get_if<query::PlaneTested<double, 3>>(&step.fact),
                          question.asks == Asks::kPVertex);
    case Asks::kPlaneSide: return plane_side_truth(asked, *std::get_if<query::PlaneTested<double, 3>>(&step.fact));
    case Asks::kVerdict: return verdict_truth(asked, std::get_if<query::Classified>(&step.fact)->result);
    case Asks::kFigure: return figure_truth(asked, *std::get_if<FrameTaken>(&step.fact));
    case Asks::kOnFront:
    case Asks::kSlowest:
    case Asks::kTimesSlower:  // decided in costs.cpp
    case Asks::kChoice: break;
  }
  const std::string& right = asked.choices[static_cast<std::size_t>(question.answer)];
  return {{question.answer}, {}, right, "The answer is “" + right + "”."};
}

/// A tapped point in the words of the choices: "the y pair (P9)". One that is of two pairs means the right one.
std::string said_by_point(const Asked& asked, const Truth& truth, Index point) {
  if (asked.question->asks != Asks::kAxis) return name(asked, point);
  std::size_t pair = asked.choices.size();
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const bool of_pair = asked.stage_points[2 * i] == point || asked.stage_points[2 * i + 1] == point;
    if (of_pair && (pair == asked.choices.size() || contains(truth.choices, static_cast<int>(i)))) pair = i;
  }
  return asked.choices[pair] + " (" + point_name(point) + ")";
}

}  // namespace

bool answers(const Asked& asked, const Answer& answer, Index points) {
  switch (answer.kind) {
    case Kind::kSkipped: return true;
    case Kind::kChoice: return answer.value >= 0 && answer.value < static_cast<int>(asked.choices.size());
    case Kind::kPoint:
      return asked.on_stage && answer.value >= 0 && answer.value < points &&
             (asked.stage_points.empty() || contains(asked.stage_points, answer.value));
  }
  return false;
}

bool same_answer(const Asked& asked, const Answer& a, const Answer& b) {
  if (a.kind == b.kind) return a.value == b.value;
  if (a.kind == Kind::kSkipped || b.kind == Kind::kSkipped || asked.question->asks == Asks::kAxis) return false;
  const Answer& choice = a.kind == Kind::kChoice ? a : b;
  const auto at = static_cast<std::size_t>(choice.value);
  return at < asked.choice_points.size() && asked.choice_points[at] == (a.kind == Kind::kChoice ? b : a).value;
}

bool is_picked(const Asked& asked, const Answer& picked, int choice) {
  if (asked.many) return (picked.value >> choice & 1) != 0;
  return same_answer(asked, picked, {Kind::kChoice, choice});
}

Outcome judge(const Asked& asked, const Answer& answer, Trace trace) {
  Truth truth = truth_of(asked, trace);
  Outcome outcome;
  outcome.question = asked.question->id;
  outcome.given = answer;
  outcome.skipped = answer.kind == Kind::kSkipped;
  outcome.from_step = asked.step;
  outcome.step = asked.until;
  outcome.because = asked.because;
  if (answer.kind == Kind::kPoint) {
    outcome.predicted = said_by_point(asked, truth, answer.value);
    outcome.right = contains(truth.points, answer.value);
  } else if (answer.kind == Kind::kChoice) {
    outcome.predicted = asked.choices[static_cast<std::size_t>(answer.value)];
    outcome.right = contains(truth.choices, answer.value);
  }
  outcome.says = std::move(truth.sentence);
  outcome.happened = std::move(truth.happened);
  return outcome;
}

Answer model_answer(const Asked& asked, Trace trace) {
  const Truth truth = truth_of(asked, trace);
  if (!truth.choices.empty()) return {Kind::kChoice, truth.choices.front()};
  return {Kind::kPoint, truth.points.front()};
}

}  // namespace snug::lesson
