#include "app/shown.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

#include "fit/obb/principal_axes.hpp"
#include "lesson/box_figures.hpp"
#include "lesson/frustum_figures.hpp"

namespace snug::app {
namespace {

using Entry = Recorder<fit::Step3>::Entry;
using Steps = std::span<const Entry>;

template <class Fact>
const Fact* last(Steps steps) {
  for (auto entry = steps.rbegin(); entry != steps.rend(); ++entry)
    if (const auto* fact = std::get_if<Fact>(&entry->step.fact)) return fact;
  return nullptr;
}

/// The ball before the last step, where that step changed it.
std::optional<fit::Volume3> ball_before(Steps steps) {
  if (steps.size() < 2) return std::nullopt;
  const fit::Sphere3* now = ball_of(steps[steps.size() - 1].step);
  const fit::Sphere3* earlier = ball_of(steps[steps.size() - 2].step);
  if (now == nullptr || earlier == nullptr || (earlier->center == now->center && earlier->radius == now->radius))
    return std::nullopt;
  return *earlier;
}

Point3 deviations(const Point3& variances) { return variances.cwiseMax(0).cwiseSqrt(); }

/// Fills in what each fact has to show. Facts without anything of their own are left to the defaults.
struct Filler {
  Shown& shown;
  const fit::Step3& step;
  Steps steps;  // up to and with this one
  const AnyPointSet& points;

  void operator()(const fit::ExtremesFound<double, 3>& fact) const { shown.extremes = {fact.least, fact.greatest}; }
  void operator()(const fit::MidpointFound<double, 3>& fact) const {
    shown.box = {fact.least, fact.greatest, fact.midpoint};
    if (const auto* found = last<fit::ExtremesFound<double, 3>>(steps))
      shown.extremes = {found->least, found->greatest};
  }
  void operator()(const fit::PairChosen& fact) const {
    shown.pair = fact;
    if (const auto* found = last<fit::ExtremesFound<double, 3>>(steps))
      shown.extremes = {found->least, found->greatest};
    if (const auto* axes = last<fit::AxesFound<double, 3>>(steps)) {
      shown.mean = axes->mean;
      shown.spread = {axes->axes, deviations(axes->variances), true, true};
    }
  }
  void operator()(const fit::FarthestFound& fact) const {
    shown.examined = fact.point;
    if (const auto* found = last<fit::MidpointFound<double, 3>>(steps))
      shown.box = {found->least, found->greatest, found->midpoint};
  }
  void operator()(const fit::PointExamined& fact) const {
    shown.examined = fact.point;
    shown.examined_outside = fact.outside;
    const fit::Sphere3* ball = ball_of(step);
    shown.outside_by = ball != nullptr ? fact.distance - ball->radius : 0;
    force(fact.depth);
  }
  void operator()(const fit::BallGrown<double, 3>& fact) const { shown.before = fact.before; }
  void operator()(const fit::MeanFound<double, 3>& fact) const { shown.mean = fact.mean; }
  void operator()(const fit::CovarianceFound<double, 3>& fact) const {
    shown.mean = fact.mean;
    const auto found = fit::principal_axes(fact);
    shown.spread = {found.axes, deviations(found.variances), false, false};
  }
  void operator()(const fit::AxesFound<double, 3>& fact) const {
    shown.mean = fact.mean;
    shown.spread = {fact.axes, deviations(fact.variances), true, false};
  }
  void operator()(const fit::BallShrunk<double, 3>& fact) const { shown.before = fact.before; }
  void operator()(const fit::PassJudged<double, 3>& fact) const {
    if (!fact.better) shown.candidate = fact.best;
  }
  void operator()(const fit::BoundaryForced& fact) const {
    shown.before = ball_before(steps);
    force(fact.depth);
  }
  void operator()(const fit::MovedToFront& fact) const {
    shown.examined = fact.point;
    force(fact.depth);
  }
  void operator()(const fit::AllChecked&) const {}
  void operator()(const fit::RadiusChecked& fact) const { shown.examined = fact.farthest; }
  void operator()(const fit::SupportReplaced&) const { shown.before = ball_before(steps); }
  void operator()(const fit::CandidateTried<double, 3>& fact) const {
    using Verdict = fit::CandidateTried<double, 3>::Verdict;
    if (fact.verdict == Verdict::kKept) {
      shown.before = ball_before(steps);
      return;
    }
    if (fact.verdict != Verdict::kNoBall) shown.candidate = fact.candidate;
    shown.candidate_fails = true;
    shown.left_outside = fact.outside;
  }
  void operator()(const fit::ExtentsFound<double, 3>& fact) const {
    spread_of_points();
    spoken_of(fact.least), spoken_of(fact.greatest);
  }
  void operator()(const fit::BallFound<double, 3>& fact) const {
    shown.before = fact.ball;
    spoken_of(fact.support);
  }
  void operator()(const fit::HullFound& fact) const { shown.hull = fact.vertices; }
  void operator()(const fit::SurfaceFound<double, 3>& fact) const {
    shown.mean = fact.centroid;
    hull();
  }
  void operator()(const fit::PointsChosen& fact) const { spoken_of(fact.points); }
  void operator()(const fit::BoxTried<double, 3>& fact) const {
    if (!fact.better) shown.candidate = fact.box;
    spoken_of(fact.on);
    hull();
  }
  void operator()(const fit::RectangleFound<double, 3>& fact) const {
    if (!fact.better) shown.candidate = fact.box;
    for (const Index end : {fact.edge_a, fact.edge_b})
      if (end != kNoIndex) shown.spoken_of.push_back(end);
    hull();
  }
  void operator()(const fit::EdgeSearched& fact) const {
    shown.spoken_of = {fact.a, fact.b};
    hull();
  }
  void operator()(const fit::BoxWidened& fact) const { shown.spoken_of = {fact.point}; }
  void operator()(const fit::LineFound& fact) const { spoken_of(fact.support); }
  void operator()(const fit::EndPulledIn& fact) const { shown.spoken_of = {fact.point}; }
  void operator()(const fit::ThicknessFound& fact) const { shown.spoken_of = {fact.least, fact.greatest}; }
  void operator()(const fit::SidePulledIn& fact) const { shown.spoken_of = {fact.point}; }
  void operator()(const fit::CornerMovedOut& fact) const { shown.spoken_of = {fact.point}; }
  void operator()(const fit::SlabFound& fact) const { shown.spoken_of = {fact.least, fact.greatest}; }
  void operator()(const fit::SimplexChosen& fact) const { spoken_of(fact.points); }
  void operator()(const fit::FlatFound& fact) const { spoken_of(fact.points); }
  void operator()(const fit::PointsAssigned&) const {}
  void operator()(const fit::EyeChosen& fact) const { shown.spoken_of = {fact.point}; }
  void operator()(const fit::EdgeSplit& fact) const { shown.spoken_of = {fact.a, fact.point, fact.b}; }
  void operator()(const fit::HorizonFound& fact) const { spoken_of(fact.horizon); }
  void operator()(const fit::FacetsReplaced& fact) const { shown.spoken_of = {fact.eye}; }
  void operator()(const fit::FacesMerged&) const {}
  void operator()(const query::FramesRelated<double, 3>&) const {}
  void operator()(const query::AxisTested<double, 3>&) const {}  // lesson::axis_at has it
  void operator()(const query::LookedCloser&) const {}
  void operator()(const query::OutlinesCompared& fact) const { shown.outlines = fact; }
  void operator()(const query::CornerTried& fact) const { shown.corner = fact; }
  void operator()(const query::Claimed& fact) const { shown.overlap = fact.overlap; }
  void operator()(const query::Verdict<double, 3>& fact) const { shown.overlap = fact.result.overlap; }
  void operator()(const query::PlaneTested<double, 3>& fact) const {
    shown.plane = fact;
    shown.verdict = fact.so_far;
    for (const int corner : {fact.p_vertex, fact.n_vertex})
      shown.spoken_of.push_back(lesson::index_of(fit::dim_of(points), {lesson::Place::Kind::kCorner, 0, corner}));
  }
  void operator()(const query::CornerTested<double, 3>&) const { corners(steps); }
  /// With the plane that all of the box is outside of. Of all planes together, the corners tested against the last one
  /// alone say nothing.
  void operator()(const query::Classified& fact) const {
    corners(steps.first(steps.size() - 1));
    const std::size_t once = std::size_t{1} << fit::dim_of(points);
    if (fact.result.rejected_by < 0 && steps.size() - 1 > once) shown.corners.clear();
    const auto* plane = last<query::PlaneTested<double, 3>>(steps);
    if (plane != nullptr && fact.result.rejected_by >= 0) (*this)(*plane);
    shown.verdict = fact.result.verdict;
  }
  void operator()(const fit::FrameTaken&) const {}
  void operator()(const fit::Finished&) const {}

  /// Those of this round: the corners are gone through in order, for each plane or once.
  void corners(Steps up_to) const {
    for (; !up_to.empty(); up_to = up_to.first(up_to.size() - 1)) {
      const auto* corner = std::get_if<query::CornerTested<double, 3>>(&up_to.back().step.fact);
      if (corner == nullptr || (!shown.corners.empty() && corner->corner >= shown.corners.front().corner)) return;
      shown.corners.insert(shown.corners.begin(), *corner);
    }
  }

  void spoken_of(const std::vector<Index>& points) const {
    shown.spoken_of.insert(shown.spoken_of.end(), points.begin(), points.end());
  }
  void hull() const {
    if (const auto* found = last<fit::HullFound>(steps)) shown.hull = found->vertices;
  }
  /// Mean and axes stay in sight where the box is built on them.
  void spread_of_points() const {
    const auto* axes = last<fit::AxesFound<double, 3>>(steps);
    if (axes == nullptr) return;
    shown.mean = axes->mean;
    shown.spread = {axes->axes, deviations(axes->variances), true, false};
  }

  /// The first `depth` points of the boundary are forced while a frame of that depth runs.
  void force(int depth) const {
    shown.depth = depth;
    const auto* boundary = last<fit::BoundaryForced>(steps);
    if (boundary == nullptr) return;
    for (int i = 0; i < std::min(depth, boundary->boundary.size()); ++i) shown.forced.add(boundary->boundary[i]);
  }
};

/// The points that an answer means, of a question that is about points.
std::vector<Index> points_of(const lesson::Asked& asked, const lesson::Answer& answer) {
  if (answer.kind == lesson::Answer::Kind::kPoint) return {answer.value};
  const auto choice = static_cast<std::size_t>(answer.value);
  if (answer.kind == lesson::Answer::Kind::kSkipped || choice >= asked.choice_points.size()) return {};
  if (asked.question->asks == lesson::Question::Asks::kAxis)
    return {asked.stage_points[2 * choice], asked.stage_points[2 * choice + 1]};
  return asked.choice_points[choice] == kNoIndex ? std::vector<Index>{} : std::vector{asked.choice_points[choice]};
}

/// A question about an axis or a plane shows which one it means, and leaves the answer to be found.
void show_asked(Shown& shown, const lesson::Session& session) {
  const lesson::Asked* asked = session.asked();
  if (asked == nullptr) return;
  if (asked->question->asks == lesson::Question::Asks::kVerdict) shown.verdict.reset();  // it is what is asked
  const auto& fact = session.recording(0).steps[asked->fact].step.fact;
  if (const auto* axis = std::get_if<query::AxisTested<double, 3>>(&fact)) shown.axis_asked = *axis;
  const auto* plane = std::get_if<query::PlaneTested<double, 3>>(&fact);
  if (plane == nullptr) return;
  shown.plane = *plane;
  shown.plane_at = plane->plane;
  shown.plane_asked = true;
  shown.spoken_of.clear();
}

void show_outcome(Shown& shown, const lesson::Session& session) {
  const lesson::Outcome* outcome = session.outcome();
  if (outcome == nullptr || outcome->skipped) return;
  for (const lesson::Asked& asked : session.questions()) {
    if (asked.question->id != outcome->question) continue;
    const std::vector<Index> given = points_of(asked, outcome->given);
    if (!outcome->right) shown.guessed_wrong = given;
    // If several answers are right, the one that was given.
    shown.right = outcome->right && !given.empty()
                      ? given
                      : points_of(asked, lesson::model_answer(asked, session.recording(0).steps));
  }
}

}  // namespace

Shown shown_at(const lesson::Session& session, bool want_optimum) {
  Shown shown;
  if (const Entry* rival = session.current(1); rival != nullptr && rival->step.has_volume)
    shown.rival = rival->step.volume;
  if (const Entry* entry = session.current(0); entry != nullptr) {
    const Steps steps = Steps(session.recording(0).steps).first(session.step());
    if (entry->step.has_volume) shown.volume = entry->step.volume;
    shown.support = session.support(0);
    shown.axis = lesson::axis_at(steps);
    shown.plane_at = lesson::plane_at(steps);
    std::visit(Filler{shown, entry->step, steps, session.points()}, entry->step.fact);
    shown.finished = session.step() == session.steps();
  }
  show_asked(shown, session);
  show_outcome(shown, session);
  // An exact method's result is the optimum: no second run says it better.
  if (shown.finished && session.algorithm(0)->exact) shown.optimum = shown.volume;
  else if (want_optimum || shown.finished)
    if (const fit::Recording* optimum = session.optimum()) shown.optimum = optimum->result.volume;
  return shown;
}

}  // namespace snug::app
