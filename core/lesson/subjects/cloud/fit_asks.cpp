#include "lesson/subjects/cloud/fit_asks.hpp"

#include <algorithm>

#include "geometry/tolerance.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"
#include "lesson/subjects/cloud/passes.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

/// Whether a radius grew by more than the last digits that the final check may add.
bool grew(double before, double after) {
  return after - before > tolerance::kBoundaryRoundoffs * tolerance::kRoundoff<double> * after;
}

/// Whether a pass ends smaller by more than rounding: "It ends at 0.9918, smaller than the best before, 0.9920."
Truth pass_truth(double radius, double best) {
  const auto [own, before] = number_texts_apart(radius, best);
  if (own == before) return no("It ends at " + own + ", as large as the best before, but for rounding.");
  const std::string than_best = " than the best before, " + before + ".";
  if (radius < best) return yes("It ends at " + own + ", smaller" + than_best);
  return no("It ends at " + own + ", larger" + than_best);
}

}  // namespace

const char* offer_axes(Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  if (fact_of<PairChosen>(asked, run).axis == kNoIndex)
    return "\"axis\" can only be asked of a pair of extreme points along the axes";
  const ExtremesFound<double, 3>* extremes = nullptr;
  for (int i = asked.fact; extremes == nullptr && i-- > 0;)
    extremes = std::get_if<ExtremesFound<double, 3>>(&trace[i].step.fact);
  if (extremes == nullptr) return "\"axis\" can only be asked after the extreme points are found";
  for (int axis = 0; axis < asked.dim; ++axis) {
    const std::vector<Index> pair{extremes->least[axis], extremes->greatest[axis]};
    asked.add_choice(std::string("the ") + "xyz"[axis] + " pair", pair);
    asked.stage_points.insert(asked.stage_points.end(), pair.begin(), pair.end());
  }
  asked.on_stage = true;
  return nullptr;
}

Truth axis_truth(const Asked& asked, const Run& run) {
  const auto& pair = fact_of<PairChosen>(asked, run);
  const std::string& choice = asked.choices[pair.axis];
  const std::vector<Index> ends{pair.a, pair.b};
  Truth truth{{pair.axis}, ends, choice, asked.names(ends) + ", " + choice + ", lie farthest apart."};
  const auto length = [&](const std::vector<Index>& of) {
    return (asked.subject->at(of[0]) - asked.subject->at(of[1])).norm();
  };
  for (int axis = 0; axis < std::ssize(asked.choices); ++axis) {
    const std::vector<Index>& other = asked.choice_handles[axis];
    if (axis == pair.axis || length(other) != length(ends)) continue;
    truth.choices.push_back(axis);
    truth.points.insert(truth.points.end(), other.begin(), other.end());
    truth.sentence += " " + asked.names(other) + " are equally far apart: either pair is right.";
  }
  return truth;
}

Truth grows_truth(const Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  const auto size = [&](int steps) { return steps == 0 ? 0.0 : fit::size_of(trace[steps - 1].step.volume, asked.dim); };
  const bool ball = std::holds_alternative<fit::Sphere3>(trace[asked.until - 1].step.volume);
  const std::string it = std::string("The ") + (ball ? "radius" : asked.dim == 2 ? "area" : "volume");
  const double before = size(asked.step), after = size(asked.until);
  if (grew(before, after)) return yes(it + " grows from " + number_text(before) + " to " + number_text(after) + ".");
  if (grew(after, before)) return no(it + " shrinks from " + number_text(before) + " to " + number_text(after) + ".");
  return no(it + " stays " + number_text(before) + ".");
}

/// The choices of "sign".
constexpr int kRaises = 0, kLowers = 1, kSame = 2;

const char* offer_signs(Asked& asked, const Run& run) {
  asked.of = asked.subject->name_of(fact_of<ProductsAdded<double, 3>>(asked, run).point);
  for (const char* choice : {"It grows", "It shrinks", "It stays the same"}) asked.add_choice(choice);
  return nullptr;
}

Truth sign_truth(const Asked& asked, const Run& run) {
  const auto& fact = fact_of<ProductsAdded<double, 3>>(asked, run);
  const double product = fact.offset[0] * fact.offset[1];
  const int choice = product > 0 ? kRaises : product < 0 ? kLowers : kSame;
  const std::string factors = number_text(fact.offset[0]) + " · " + number_text(fact.offset[1]);
  return {{choice}, {}, asked.choices[choice], "The product is " + factors + " = " + number_text(product) + "."};
}

const char* offer_support(Asked& asked, const Run& run) {
  asked.add_choice("none");
  for (const Index i : run.support(asked.fact)) {
    asked.add_choice(asked.subject->name_of(i), {i});
    asked.stage_points.push_back(i);
  }
  if (asked.stage_points.empty()) return "\"leaves\" cannot be asked while no point supports the sphere";
  asked.on_stage = true;
  return nullptr;
}

Truth leaves_truth(const Asked& asked, const Run& run) {
  const std::vector<Index> after = run.support(asked.until);
  Truth truth;
  for (std::size_t i = 1; i < asked.choices.size(); ++i) {
    const Index point = asked.choice_handles[i].front();
    if (std::find(after.begin(), after.end(), point) != after.end()) continue;
    truth.choices.push_back(static_cast<int>(i));
    truth.points.push_back(point);
  }
  if (truth.choices.empty()) return {{0}, {}, "none", "No point left the support set."};
  truth.happened = asked.names(truth.points);
  truth.sentence = truth.happened + " left the support set.";
  return truth;
}

Truth better_truth(const Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  const Step3& step = trace[asked.fact].step;
  const auto* pass = std::get_if<PassJudged<double, 3>>(&step.fact);
  const auto* tried = std::get_if<CandidateTried<double, 3>>(&step.fact);
  const bool better = pass != nullptr ? pass->better : tried->verdict == CandidateTried<double, 3>::Verdict::kKept;
  if (const auto best = best_before(trace, asked.fact + 1))
    return pass_truth(fit::size_of(step.volume, asked.dim), *best);
  if (better) return yes("It is the smallest so far, and is kept.");
  if (tried != nullptr && tried->outside != kNoIndex)
    return no(asked.subject->name_of(tried->outside) + " lies outside, so it is not kept.");
  return no("It is no smaller than the best so far.");
}

const char* offer_counts(Asked& asked, const Run&) {
  for (int n = 1; n <= asked.dim + 1; ++n) asked.add_choice(std::to_string(n));
  return nullptr;
}

Truth holds_truth(const Asked& asked, const Run& run) {
  const std::vector<Index>& points = fact_of<Finished>(asked, run).support;
  const auto n = static_cast<int>(points.size());
  return {{n - 1},
          points,
          std::to_string(n),
          asked.names(points) + (n == 1 ? " supports" : " support") + " the " + ball_word(asked.dim) + "."};
}

const char* offer_first_wrong(Asked& asked, const Run& run) {
  const FitRun& own = fit_run(run);
  if (own.wrong() == nullptr || asked.fact + 1 != own.steps())
    return "\"first_wrong\" can only be asked of the last step of a naive algorithm's run";
  return offer_points_or_none(asked, run);
}

/// A tap on the stage cannot tell points in the same place apart, so all of them are right.
void add_points_in_same_places(Truth& truth, const FitRun& run) {
  const std::vector<Index> found = truth.points;
  for (Index i = 0; i < fit::count_of(run.points()); ++i) {
    const auto same = [&](Index one) { return fit::point_of(run.points(), one) == fit::point_of(run.points(), i); };
    if (std::find(found.begin(), found.end(), i) != found.end() || std::none_of(found.begin(), found.end(), same))
      continue;
    truth.points.push_back(i);
    truth.choices.push_back(static_cast<int>(i) + 1);
  }
}

/// Several points are right where one step is wrong about several.
Truth first_wrong_truth(const Asked&, const Run& run) {
  const FitRun& own = fit_run(run);
  if (own.wrong()->empty()) return {{0}, {}, "none", "Every test of this run is right."};
  const int step = own.wrong()->front().step;
  Truth truth;
  for (const WrongTest& test : own.wrong_at(step)) {
    truth.points.push_back(test.point);
    truth.choices.push_back(static_cast<int>(test.point) + 1);
  }
  const FitRun::Where where{own, step, nullptr};
  truth.happened = where.names(truth.points);
  truth.sentence = "In step " + count_text(step + 1) + " the test of " + truth.happened + " is the first to be wrong." +
                   where.contradiction();
  add_points_in_same_places(truth, own);
  return truth;
}

const char* offer_left_outside(Asked& asked, const Run& run) {
  const FitRun& own = fit_run(run);
  if (!left_by(own.points(), own.recording().result) || asked.fact + 1 != own.steps())
    return "\"outside\" can only be asked of the last step of a sphere's run, or of a hull's in the plane";
  return offer_points_or_none(asked, run);
}

Truth left_outside_truth(const Asked& asked, const Run& run) {
  const FitRun& own = fit_run(run);
  const LeftOutside left = *left_by(own.points(), own.recording().result);
  if (left.points.empty()) return {{0}, {}, "none", "Every point is inside, in exact arithmetic."};
  Truth truth{{}, left.points, asked.names(left.points), {}};
  for (const Index i : left.points) truth.choices.push_back(static_cast<int>(i) + 1);
  truth.sentence = truth.happened + (left.points.size() == 1 ? " is" : " are") + " left outside" +
                   (left.points.size() == 1 ? " by " : ", " + asked.subject->name_of(left.worst) + " by ") +
                   worst_text(left, of_ulps(own.recording().result)) + ".";
  return truth;
}

int after_recursion(const Run& run, int fact) {
  const FitTrace trace = fit_run(run).trace();
  if (!std::holds_alternative<BoundaryForced>(trace[fact].step.fact)) return fact + 1;
  for (int i = fact; i < run.steps(); ++i)
    if (std::holds_alternative<MovedToFront>(trace[i].step.fact) && run.counts(i)) return i + 1;
  return fact + 1;
}

}  // namespace snug::lesson
