#include "app/subjects/cloud/shown.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "fit/obb/principal_axes.hpp"
#include "lesson/subjects/cloud/calipers_turn.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

/// The ball before the last step, if that step changed it.
std::optional<fit::Volume3> ball_before(lesson::FitTrace steps) {
  if (steps.size() < 2) return std::nullopt;
  const fit::Sphere3* now = ball_of(steps[steps.size() - 1].step);
  const fit::Sphere3* earlier = ball_of(steps[steps.size() - 2].step);
  if (now == nullptr || earlier == nullptr || (earlier->center == now->center && earlier->radius == now->radius))
    return std::nullopt;
  return *earlier;
}

Point3 deviations(const Point3& variances) { return variances.cwiseMax(0).cwiseSqrt(); }

/// Fills in what facts show beyond marks on points.
struct CloudFiller {
  CloudShown& shown;
  const fit::Step3& step;
  lesson::FitTrace steps;  // up to and including this one
  const lesson::Session& session;

  void operator()(const auto&) const { named(); }
  void operator()(const fit::ExtremesFound<double, 3>& fact) const { shown.extremes = {fact.least, fact.greatest}; }
  void operator()(const fit::MidpointFound<double, 3>& fact) const {
    shown.box = {fact.least, fact.greatest, fact.midpoint};
    if (const auto* found = last_fact<fit::ExtremesFound<double, 3>>(steps))
      shown.extremes = {found->least, found->greatest};
  }
  void operator()(const fit::PairChosen& fact) const {
    shown.pair = fact;
    if (const auto* found = last_fact<fit::ExtremesFound<double, 3>>(steps))
      shown.extremes = {found->least, found->greatest};
    if (const auto* axes = last_fact<fit::AxesFound<double, 3>>(steps)) {
      shown.mean = axes->mean;
      shown.spread = {axes->axes, deviations(axes->variances), true, true};
    }
  }
  void operator()(const fit::FarthestFound& fact) const {
    shown.examined = fact.point;
    if (const auto* found = last_fact<fit::MidpointFound<double, 3>>(steps))
      shown.box = {found->least, found->greatest, found->midpoint};
  }
  void operator()(const fit::PointExamined& fact) const {
    shown.examined = fact.point;
    shown.examined_outside = fact.outside;
    const fit::Sphere3* ball = ball_of(step);
    shown.outside_by = ball != nullptr ? fact.distance - ball->radius : 0;
    force(fact.depth);
  }
  void operator()(const fit::BallGrown<double, 3>& fact) const {
    shown.before = fact.before;
    shown.grown = fact;
  }
  void operator()(const fit::MeanFound<double, 3>& fact) const { shown.mean = fact.mean; }
  void operator()(const fit::CovarianceFound<double, 3>& fact) const {
    shown.mean = fact.mean;
    const auto found = fit::principal_axes(fact);
    shown.spread = {found.axes, deviations(found.variances), false, false};
  }
  void operator()(const fit::ProductsAdded<double, 3>& fact) const {
    shown.products = {fact.point, session.stage().subject().at(fact.point) - fact.offset};
    if (fact.from_mean)
      if (const auto* mean = last_fact<fit::MeanFound<double, 3>>(steps)) shown.mean = mean->mean;
    shown.spoken_of = {fact.point};
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
  void operator()(const fit::RadiusChecked& fact) const { shown.examined = fact.farthest; }
  void operator()(const fit::SupportReplaced&) const { shown.before = ball_before(steps); }
  void operator()(const fit::CandidateTried<double, 3>& fact) const {
    using Verdict = fit::CandidateTried<double, 3>::Verdict;
    if (fact.verdict == Verdict::kKept) {
      shown.before = ball_before(steps);
      return;
    }
    if (fact.verdict != Verdict::kNoBall && fact.verdict != Verdict::kDependent) shown.candidate = fact.candidate;
    shown.candidate_fails = true;
    shown.left_outside = fact.outside;
  }
  void operator()(const fit::ExtentsFound<double, 3>&) const {
    spread_of_points();
    named();
  }
  void operator()(const fit::BallFound<double, 3>& fact) const {
    shown.before = fact.ball;
    named();
  }
  void operator()(const fit::HullFound&) const { hull(); }
  void operator()(const fit::SurfaceFound<double, 3>& fact) const {
    shown.mean = fact.centroid;
    hull();
  }
  void operator()(const fit::BoxTried<double, 3>& fact) const {
    if (!fact.better) shown.candidate = fact.box;
    shown.spoken_of = {fact.on.begin(), fact.on.end()};
    hull();
    build_on(fact.on);
  }
  void operator()(const fit::RotationTried<double, 3>&) const { hull(); }
  void operator()(const fit::RectangleFound<double, 3>& fact) const {
    if (!fact.better) shown.candidate = fact.box;
    named();
    hull();
    build_on({fact.edge_a, fact.edge_b});
    if (session.stage().subject().dim() == 3) shown.along = fact.along;
  }
  void operator()(const fit::CalipersTurned<double, 3>& fact) const {
    shown.candidate = fact.box;
    named();
    hull();
    build_on({fact.touching[0], fact.touching[1]});
    shown.along = fact.along;
    shown.calipers = fact.touching;
    if (fact.better) return;
    for (const auto* turned : lesson::calipers_turn(steps, static_cast<int>(steps.size())))
      if (turned->better) shown.smallest = turned->box;
  }
  void operator()(const fit::EdgeSearched& fact) const {
    named();
    hull();
    build_on({fact.a, fact.b});
  }
  void operator()(const fit::PointsAssigned&) const {}
  void operator()(const fit::EyeChosen& fact) const {
    shown.examined = fact.point;
    shown.examined_outside = true;
  }
  void operator()(const fit::EdgeSplit& fact) const { shown.spoken_of = {fact.a, fact.point, fact.b}; }
  void operator()(const fit::HorizonFound& fact) const { shown.examined = fact.eye; }
  void operator()(const fit::FacetsReplaced& fact) const { shown.spoken_of = {fact.eye}; }
  void operator()(const fit::FacesMerged&) const {
    if (shown.growing)
      shown.flat = lesson::flat_edges(*shown.growing, lesson::fit_run(session.player().run(0)).points());
  }
  void operator()(const fit::CallEntered& fact) const {
    shown.examined = fact.point;
    shown.forced = fact.boundary;
    if (fact.point == kNoIndex) shown.before = ball_before(steps);
  }
  void operator()(const fit::CallDecided& fact) const {
    shown.examined = fact.point;
    const fit::Sphere3* ball = ball_of(step);
    shown.examined_outside = fact.outside && ball != nullptr;
    shown.outside_by = ball != nullptr ? fact.distance - ball->radius : 0;
    shown.forced = fact.boundary;
  }
  void operator()(const fit::RecursionStopped&) const {}
  void operator()(const fit::SlabFound& fact) const {
    const auto& run = lesson::fit_run(session.player().run(0));
    const int last = static_cast<int>(steps.size()) - 1;
    const Point3 axis = run.slab_axis(last, fact.slab);
    const double length = axis.norm();
    shown.slab = {fact.slab + 1,
                  axis / length,
                  fact.min / length,
                  fact.max / length,
                  fact.least,
                  fact.greatest,
                  run.slab_name(last, fact.slab)};
    named();
  }
  void operator()(const fit::Finished&) const {}  // its support set is marked anyway

  void named() const { shown.spoken_of = named_now(session); }
  void hull() const {
    const auto* found = last_fact<fit::HullFound>(steps);
    if (found == nullptr) return;
    shown.hull = found->vertices;
    const AnyPointSet* points = session.stage().subject().points();
    if (session.stage().subject().dim() == 3 && points != nullptr)
      shown.hull_solid = fit::find_algorithm("hull", "quickhull")->fit(*points, {}).volume;
  }
  /// Two points are an edge, three a face, four two edges.
  void build_on(const std::vector<Index>& on) const {
    if (std::find(on.begin(), on.end(), kNoIndex) != on.end()) return;
    if (on.size() == 2 || on.size() == 4)
      for (std::size_t i = 0; i < on.size(); i += 2) shown.built_on.push_back({on[i], on[i + 1]});
    if (on.size() == 3)
      for (std::size_t i = 0; i < 3; ++i) shown.built_on.push_back({on[i], on[(i + 1) % 3]});
  }
  /// Keeps mean and axes visible while the box is built on them.
  void spread_of_points() const {
    const auto* axes = last_fact<fit::AxesFound<double, 3>>(steps);
    if (axes == nullptr) return;
    shown.mean = axes->mean;
    shown.spread = {axes->axes, deviations(axes->variances), true, false};
  }

  /// Marks the first `depth` points of the boundary as forced, while a call of that depth runs.
  void force(int depth) const {
    shown.depth = depth;
    const auto* boundary = last_fact<fit::BoundaryForced>(steps);
    if (boundary == nullptr) return;
    for (int i = 0; i < std::min(depth, boundary->boundary.size()); ++i) shown.forced.add(boundary->boundary[i]);
  }
};

/// Where the lesson compares with something, that is shown; else only the smallest of its kind, where it is known.
void show_optimum(CloudShown& shown, const lesson::Session& session, bool wanted) {
  const auto* cloud = lesson::as<lesson::CloudSubject>(session.stage().subject());
  if (cloud == nullptr) {
    shown.optimum_word = "smallest " + std::string(lesson::volume_word(session.player().method(0)->volume,
                                                                       session.stage().subject().dim()));
    return;
  }
  shown.optimum.reset();
  const lesson::Method* than = cloud->compared_with();
  if (!wanted || than == nullptr || is_itself(*than, session)) return;
  const fit::Recording* optimum = cloud->optimum(session.player().view());
  if (optimum == nullptr) return;
  shown.optimum = optimum->result.volume;
  shown.optimum_word = cloud->reference(session.player().view()).word;
}

std::optional<lesson::LeftOutside> left_outside_now(const lesson::Session& session) {
  const fit::Recording& run = lesson::fit_run(session.player().run(0)).recording();
  const bool naive = session.player().method(0)->naive;  // its hull may have dents, though it contains every point
  if (!session.player().view().at_end() || (run.certificate.contains && !naive)) return std::nullopt;
  auto left = lesson::left_by(lesson::fit_run(session.player().run(0)).points(), run.result);
  return left && left->none() ? std::nullopt : left;
}

std::optional<lesson::CertificateLines> certificate_now(const lesson::Session& session) {
  const auto* cloud = lesson::as<lesson::CloudSubject>(session.stage().subject());
  if (cloud == nullptr || !cloud->offers_naive() || !session.player().view().at_end()) return std::nullopt;
  return lesson::certificate_lines(lesson::fit_run(session.player().run(0)), &cloud->unrounded_points());
}

}  // namespace

bool is_itself(const lesson::Method& reference, const lesson::Session& session) {
  return !reference.exact && &reference == session.player().method(0);
}

CloudShown cloud_shown_at(const lesson::Session& session, bool want_optimum) {
  CloudShown shown{shown_at(session)};
  const lesson::FitTrace steps = lesson::fit_run(session.player().run(0)).trace().first(session.player().step());
  show_optimum(shown, session, want_optimum || shown.finished);
  shown.growing = lesson::growing_hull(lesson::fit_run(session.player().run(0)).trace(), session.player().step());
  if (shown.growing && !shown.volume) shown.support = shown.growing->vertices();  // some are gone again
  shown.left = left_outside_now(session);
  shown.certificate = certificate_now(session);
  if (!steps.empty())
    for (const lesson::WrongTest& test : lesson::fit_run(session.player().run(0)).wrong_at(session.player().step() - 1))
      shown.wrong.push_back(test.point);
  if (!steps.empty()) std::visit(CloudFiller{shown, steps.back().step, steps, session}, steps.back().step.fact);
  return shown;
}

}  // namespace snug::app
