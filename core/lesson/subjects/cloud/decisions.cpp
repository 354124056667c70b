#include "lesson/subjects/cloud/decisions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/catalogue.hpp"
#include "lesson/decide.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/cloud/fit_asks.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/subjects/cloud/hull_growth.hpp"
#include "lesson/subjects/cloud/passes.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

constexpr double kNever = std::numeric_limits<double>::infinity();

Index count_of(const Run& run) { return fit::count_of(fit_run(run).points()); }
Point3 point_at(const Run& run, Index i) { return fit::point_of(fit_run(run).points(), i); }
double share(const Asked& asked, double length) { return length / extent_of(*asked.subject); }

/// The ball that stands before a step; one around the midpoint of a box while there is none.
Sphere3 ball_before(const Run& run, int step) {
  const FitTrace trace = fit_run(run).trace();
  for (int i = step; i-- > 0;) {
    if (const auto* found = std::get_if<MidpointFound<double, 3>>(&trace[i].step.fact)) return {found->midpoint, 0};
    if (const auto* found = std::get_if<MeanFound<double, 3>>(&trace[i].step.fact)) return {found->mean, 0};
    if (!trace[i].step.has_volume) continue;
    if (const auto* ball = std::get_if<Sphere3>(&trace[i].step.volume)) return *ball;
  }
  return {Point3::Zero(), 0};
}

template <class Value>
Scores scores_of_points(const Run& run, Value value) {
  Scores scores;
  for (Index i = 0; i < count_of(run); ++i) scores.add(static_cast<int>(i), value(point_at(run, i)));
  return scores;
}

Scores distances(const Asked& asked, const Run& run) {
  const Point3 center = ball_before(run, asked.fact).center;
  return scores_of_points(run, [&](const Point3& p) { return (p - center).norm(); });
}

/// The points outside a ball, by how far.
Scores outside(const Sphere3& ball, const Run& run) {
  Scores scores;
  for (Index i = 0; i < count_of(run); ++i)
    if (const double gap = (point_at(run, i) - ball.center).norm() - ball.radius; gap > 0)
      scores.add(static_cast<int>(i), gap);
  return scores;
}

void offer_all(Asked& asked, const Run& run) {
  for (Index i = 0; i < count_of(run); ++i) asked.stage_points.push_back(i);
  asked.on_stage = true;
}

Truth truth_of_point(const Asked& asked, Index point, const std::string& says) {
  const std::string name = asked.subject->name_of(point);
  return {{}, {point}, name, name + ' ' + says + '.'};
}

/// "P3 is farthest from the centre, at 2.5.": each of the greatest is right, and the run goes on with one of them.
Truth truth_of_greatest(const Asked& asked, const Scores& scores, Index taken, const std::string& from) {
  const double most = scores.values[std::find(scores.of.begin(), scores.of.end(), taken) - scores.of.begin()];
  const std::string at = ", at " + number_text(most);
  Truth truth = truth_of_point(asked, taken, "is farthest from " + from + at);
  for (std::size_t i = 0; i < scores.of.size(); ++i)
    if (scores.values[i] == most && scores.of[i] != taken) truth.points.push_back(scores.of[i]);
  if (truth.points.size() == 1) return truth;
  truth.sentence = asked.names(truth.points) + " are equally far from " + from + at +
                   ": each is right. The program takes " + truth.happened + ".";
  return truth;
}

}  // namespace

Scores reach_along(const Run& run, const Point3& direction) {
  return scores_of_points(run, [&](const Point3& p) { return p.dot(direction); });
}

// ---- the point farthest from a centre -----------------------------------------------------------------------

const char* offer_farthest(Asked& asked, const Run& run) {
  if (asked.fact == 0) return "\"farthest\" cannot be asked while there is no centre";
  return offer_all(asked, run), nullptr;
}

Truth farthest_truth(const Asked& asked, const Run& run) {
  const Scores from_center = distances(asked, run);
  return truth_of_greatest(asked, from_center, from_center.greatest(), "the centre");
}

double farthest_margin(const Asked& asked, const Run& run) { return share(asked, distances(asked, run).lead()); }

std::optional<Answer> nearest_point(const Asked& asked, const Run& run) {
  return by_handle(distances(asked, run).least());
}

std::optional<Answer> farthest_along_an_axis(const Asked& asked, const Run& run) {
  const Point3 center = ball_before(run, asked.fact).center;
  return by_handle(
      scores_of_points(run, [&](const Point3& p) { return (p - center).cwiseAbs().maxCoeff(); }).greatest());
}

// ---- Ritter's pair ------------------------------------------------------------------------------------------

namespace {

/// The choices by the distance of their points, or by its part along the pair's own axis.
Scores pairs(const Asked& asked, const Run& run, bool along_axis) {
  Scores scores;
  for (int axis = 0; axis < std::ssize(asked.choices); ++axis) {
    const auto& ends = asked.choice_handles[axis];
    const Point3 between = point_at(run, ends[1]) - point_at(run, ends[0]);
    scores.add(axis, along_axis ? std::abs(between[axis]) : between.norm());
  }
  return scores;
}

}  // namespace

double axis_margin(const Asked& asked, const Run& run) { return share(asked, pairs(asked, run, false).lead()); }
std::optional<Answer> nearest_pair(const Asked& asked, const Run& run) {
  return by_choice(pairs(asked, run, false).least());
}
std::optional<Answer> widest_pair(const Asked& asked, const Run& run) {
  return by_choice(pairs(asked, run, true).greatest());
}

// ---- the next point outside ---------------------------------------------------------------------------------

const char* offer_points_or_none(Asked& asked, const Run& run) {
  asked.add_choice("none");
  for (Index i = 0; i < count_of(run); ++i) asked.add_choice(asked.subject->name_of(i), {i});
  asked.on_stage = true;
  return nullptr;
}

Truth next_outside_truth(const Asked& asked, const Run& run) {
  const auto* grown = std::get_if<BallGrown<double, 3>>(&fit_run(run).trace()[asked.fact].step.fact);
  const std::string ball = asked.dim == 2 ? "circle" : "sphere";
  if (grown == nullptr)
    return {{0}, {}, "none", "No point that comes after lies outside: the " + ball + " is finished."};
  Truth truth = truth_of_point(asked, grown->point,
                               "is the next in the list that lies outside, by " +
                                   number_text(fit_run(run).gap_to(grown->point, grown->before)));
  truth.choices = {static_cast<int>(grown->point) + 1};
  return truth;
}

/// The test that came nearest to a tie since the question was asked.
double next_outside_margin(const Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  double least = kNever;
  for (int i = asked.step; i < asked.fact; ++i)
    if (const auto* tested = std::get_if<PointExamined>(&trace[i].step.fact))
      if (const auto* ball = std::get_if<Sphere3>(&trace[i].step.volume))
        least = std::min(least, std::abs(tested->distance - ball->radius));
  return share(asked, least);
}

std::optional<Answer> farthest_outside(const Asked& asked, const Run& run) {
  const Scores scores = outside(ball_before(run, asked.step), run);
  return scores.of.empty() ? std::nullopt : std::optional(by_handle(scores.greatest()));
}
std::optional<Answer> nearest_outside(const Asked& asked, const Run& run) {
  const Scores scores = outside(ball_before(run, asked.step), run);
  return scores.of.empty() ? std::nullopt : std::optional(by_handle(scores.least()));
}

// ---- inside or outside --------------------------------------------------------------------------------------

namespace {

constexpr int kInside = 0, kOutsideBall = 1;

}  // namespace

const char* offer_sides(Asked& asked, const Run& run) {
  if (ball_before(run, asked.fact + 1).radius == 0) return "\"side\" cannot be asked while there is no sphere";
  asked.of = asked.subject->name_of(fact_of<PointExamined>(asked, run).point);
  for (const char* side : {"inside", "outside"}) asked.add_choice(side);
  return nullptr;
}

Truth side_truth(const Asked& asked, const Run& run) {
  const auto& fact = fact_of<PointExamined>(asked, run);
  const auto [own, radius] = number_texts_apart(fact.distance, ball_before(run, asked.fact + 1).radius);
  const std::string at =
      asked.subject->name_of(fact.point) + " lies " + own + " from the centre, and the radius is " + radius + ": ";
  return {{fact.outside ? kOutsideBall : kInside},
          {},
          asked.choices[fact.outside ? kOutsideBall : kInside],
          at + (fact.outside ? "outside." : "inside.")};
}

double side_margin(const Asked& asked, const Run& run) {
  return share(asked, std::abs(fact_of<PointExamined>(asked, run).distance - ball_before(run, asked.fact + 1).radius));
}

std::optional<Answer> inside_the_box(const Asked& asked, const Run& run) {
  const Sphere3 ball = ball_before(run, asked.fact + 1);
  const Point3 offset = point_at(run, fact_of<PointExamined>(asked, run).point) - ball.center;
  return by_choice(offset.cwiseAbs().maxCoeff() <= ball.radius ? kInside : kOutsideBall);
}
std::optional<Answer> always_inside(const Asked&, const Run&) { return by_choice(kInside); }

// ---- who leaves the support set -----------------------------------------------------------------------------

namespace {

/// The smallest ball around some of the points, in the plane or in space.
Sphere3 ball_around(const Asked& asked, const Run& run, const std::vector<Index>& some) {
  std::vector<Point3> points;
  for (const Index i : some) points.push_back(point_at(run, i));
  const auto set = to_set(points, asked.dim);
  return std::get<Sphere3>(find_algorithm("sphere", "welzl")->fit(*set, {}).volume);
}

}  // namespace

/// A point that leaves lies inside the new ball, and one that stays outside the ball of the others: by how much at
/// least.
double leaves_margin(const Asked& asked, const Run& run) {
  const std::vector<Index> before = asked.stage_points, after = run.support(asked.until);
  const auto stays = [&](Index i) { return std::find(after.begin(), after.end(), i) != after.end(); };
  if (after.empty()) return 0;
  double least = kNever;
  const Sphere3 ball = ball_around(asked, run, after);
  for (const Index i : before)
    if (!stays(i)) least = std::min(least, ball.radius - (point_at(run, i) - ball.center).norm());
  for (const Index i : after) {
    std::vector<Index> others;
    for (const Index k : after)
      if (k != i) others.push_back(k);
    if (others.empty()) continue;
    const Sphere3 without = ball_around(asked, run, others);
    least = std::min(least, (point_at(run, i) - without.center).norm() - without.radius);
  }
  return share(asked, least);
}

std::optional<Answer> nearest_leaves(const Asked& asked, const Run& run) {
  const std::vector<Index> joined = run.handles(asked.fact);
  if (joined.empty() || asked.stage_points.size() < 2) return std::nullopt;
  Scores scores;
  for (const Index i : asked.stage_points)
    scores.add(static_cast<int>(i), (point_at(run, i) - point_at(run, joined.front())).norm());
  return by_handle(scores.least());
}
std::optional<Answer> none_leaves(const Asked&, const Run&) { return by_choice(0); }

// ---- extremes -----------------------------------------------------------------------------------------------

namespace {

/// The main axis that was found before a pair was chosen along it, if any. A plane's axes come after its normal.
std::optional<Point3> main_axis_before(const Run& run, int step) {
  for (int i = step; i-- > 0;) {
    const auto& fact = fit_run(run).trace()[i].step.fact;
    if (std::holds_alternative<PairChosen>(fact)) return std::nullopt;  // the same pair, told already
    if (const auto* found = std::get_if<AxesFound<double, 3>>(&fact)) return found->axes.col(2);
  }
  return std::nullopt;
}

/// The directions along which the step looks for extremes.
std::vector<Point3> directions(const Asked& asked, const Run& run) {
  if (std::holds_alternative<PairChosen>(fit_run(run).trace()[asked.fact].step.fact))
    if (const auto main = main_axis_before(run, asked.fact)) return {*main};
  if (const auto* slab = std::get_if<SlabFound>(&fit_run(run).trace()[asked.fact].step.fact))
    return {fit_run(run).slab_axis(asked.fact, slab->slab).normalized()};
  std::vector<Point3> axes;
  for (int axis = 0; axis < asked.dim; ++axis) axes.emplace_back(Point3::Unit(axis));
  return axes;
}

Answer extremes_along(const Run& run, const std::vector<Point3>& axes) {
  std::vector<int> ends;
  for (const Point3& axis : axes) {
    const Scores scores = reach_along(run, axis);
    ends.push_back(scores.greatest()), ends.push_back(scores.least());
  }
  return by_handles(std::move(ends));
}

}  // namespace

const char* offer_extremes(Asked& asked, const Run& run) {
  if (const auto* slab = std::get_if<SlabFound>(&fit_run(run).trace()[asked.fact].step.fact))
    asked.of = fit_run(run).slab_name(asked.fact, slab->slab);
  if (std::holds_alternative<PairChosen>(fit_run(run).trace()[asked.fact].step.fact)) {
    if (!main_axis_before(run, asked.fact)) return "\"extremes\" can be asked of a pair only along a main axis";
    asked.of = "the main axis";
  }
  asked.many = true;
  return offer_all(asked, run), nullptr;
}

Truth extremes_truth(const Asked& asked, const Run& run) {
  std::vector<int> all;
  Truth truth;
  bool is_tied = false;
  for (const Point3& axis : directions(asked, run))
    for (const double sign : {1.0, -1.0}) {
      const std::vector<int> ends = reach_along(run, sign * axis).all_greatest();
      all.insert(all.end(), ends.begin(), ends.end());
      truth.tied.emplace_back(ends.begin(), ends.end());
      is_tied = is_tied || ends.size() > 1;
    }
  if (!is_tied) truth.tied.clear();
  truth.points = by_handles(std::move(all)).handles;
  truth.happened = asked.names(truth.points);
  truth.sentence = truth.happened + " reach farthest" + (asked.of.empty() ? "" : " along " + asked.of) + ".";
  for (const std::vector<Index>& tied : truth.tied)
    if (tied.size() > 1) truth.sentence += ' ' + asked.names(tied) + " reach equally far: one of them is enough.";
  return truth;
}

double extremes_margin(const Asked& asked, const Run& run) {
  double least = kNever;
  for (const Point3& axis : directions(asked, run))
    for (const double sign : {1.0, -1.0}) least = std::min(least, reach_along(run, sign * axis).lead());
  return share(asked, least);
}

std::optional<Answer> extremes_of_one_axis(const Asked& asked, const Run& run) {
  const auto axes = directions(asked, run);
  return axes.size() < 2 ? std::nullopt : std::optional(extremes_along(run, {axes.front()}));
}

std::optional<Answer> farthest_apart(const Asked& asked, const Run& run) {
  if (directions(asked, run).size() > 1) return std::nullopt;
  Answer best;
  double most = -1;
  for (Index a = 0; a < count_of(run); ++a)
    for (Index b = a + 1; b < count_of(run); ++b)
      if (const double distance = (point_at(run, a) - point_at(run, b)).norm(); distance > most)
        most = distance, best = by_handles({a, b});
  return best;
}

std::optional<Answer> extremes_along_x(const Asked& asked, const Run& run) {
  if (directions(asked, run).size() > 1) return std::nullopt;
  return extremes_along(run, {Point3::UnitX()});
}

// ---- the farthest point of a facet --------------------------------------------------------------------------

namespace {

const GrowingFacet& facet_of(const GrowingHull& hull, const Asked& asked, const Run& run) {
  return hull.facets[fact_of<EyeChosen>(asked, run).facet];
}

std::vector<Point3> corners_of(const GrowingFacet& facet, const Run& run) {
  std::vector<Point3> corners;
  for (const Index i : facet.vertices) corners.push_back(point_at(run, i));
  return corners;
}

template <class Value>
Scores scores_of_facet(const Asked& asked, const Run& run, Value value) {
  const auto hull = growing_hull(fit_run(run).trace(), asked.fact);
  const GrowingFacet& facet = facet_of(*hull, asked, run);
  const std::vector<Point3> corners = corners_of(facet, run);
  Scores scores;
  for (const Index i : facet.outside) scores.add(static_cast<int>(i), value(point_at(run, i), corners));
  return scores;
}

/// From the line through two corners, or the plane through three.
double distance_from(const Point3& p, const std::vector<Point3>& corners) {
  const Point3 along = corners[1] - corners[0];
  const Point3 across =
      corners.size() == 3 ? Point3(along.cross(corners[2] - corners[0])) : Point3(along[1], -along[0], 0);
  return std::abs((p - corners[0]).dot(across)) / across.norm();  // in this order, what is equal stays equal
}

}  // namespace

const char* offer_eye(Asked& asked, const Run& run) {
  const auto hull = growing_hull(fit_run(run).trace(), asked.fact);
  const std::vector<Index>& corners = facet_of(*hull, asked, run).vertices;
  asked.stage_points = facet_of(*hull, asked, run).outside;
  asked.on_stage = true;
  asked.of = asked.dim == 2 ? "from " + asked.subject->name_of(corners[0]) + " to " + asked.subject->name_of(corners[1])
                            : "of " + asked.names(corners);
  return nullptr;
}

Truth eye_truth(const Asked& asked, const Run& run) {
  return truth_of_greatest(asked, scores_of_facet(asked, run, &distance_from), fact_of<EyeChosen>(asked, run).point,
                           (asked.dim == 2 ? "the edge " : "the face ") + asked.of);
}

/// A point that is alone outside leaves nothing to decide.
double eye_margin(const Asked& asked, const Run& run) {
  const Scores distances = scores_of_facet(asked, run, &distance_from);
  return distances.of.size() < 2 ? 0 : share(asked, distances.lead());
}

std::optional<Answer> farthest_from_the_middle(const Asked& asked, const Run& run) {
  const auto from_middle = [](const Point3& p, const std::vector<Point3>& corners) {
    Point3 middle = Point3::Zero();
    for (const Point3& corner : corners) middle += corner / static_cast<double>(corners.size());
    return (p - middle).norm();
  };
  return by_handle(scores_of_facet(asked, run, from_middle).greatest());
}

std::optional<Answer> nearest_to_the_facet(const Asked& asked, const Run& run) {
  return by_handle(scores_of_facet(asked, run, &distance_from).least());
}

/// How far the eye is from the nearest facet's plane: within it, "seen" would be rounding.
double faces_margin(const Asked& asked, const Run& run) {
  const auto hull = growing_hull(fit_run(run).trace(), asked.fact);
  const Point3 eye = point_at(run, fact_of<HorizonFound>(asked, run).eye);
  double least = kNever;
  for (const GrowingFacet& facet : hull->facets) {
    if (facet.alive()) least = std::min(least, distance_from(eye, corners_of(facet, run)));
  }
  return share(asked, least);
}

/// As if the eye saw only the face that it was assigned to.
std::optional<Answer> its_own_face(const Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  const auto hull = growing_hull(trace, asked.fact);
  const EyeChosen* eye = nullptr;
  for (int i = asked.fact; eye == nullptr && i-- > 0;) eye = std::get_if<EyeChosen>(&trace[i].step.fact);
  int choice = 0;
  for (std::size_t facet = 0; eye != nullptr && facet < hull->facets.size(); ++facet) {
    if (!hull->facets[facet].alive()) continue;
    if (static_cast<Index>(facet) == eye->facet) return SeveralChoices{{choice}};
    ++choice;
  }
  return std::nullopt;
}

// ---- a covariance's products --------------------------------------------------------------------------------

double sign_margin(const Asked& asked, const Run& run) {
  const auto& fact = fact_of<ProductsAdded<double, 3>>(asked, run);
  return share(asked, std::min(std::abs(fact.offset[0]), std::abs(fact.offset[1])));
}

namespace {

/// The choice of "sign" for a product: grows, shrinks.
Answer by_sign(double product) { return by_choice(product > 0 ? 0 : 1); }

}  // namespace

std::optional<Answer> sign_of_x(const Asked& asked, const Run& run) {
  return by_sign(fact_of<ProductsAdded<double, 3>>(asked, run).offset[0]);
}
std::optional<Answer> sign_about_origin(const Asked& asked, const Run& run) {
  const Point3 p = point_at(run, fact_of<ProductsAdded<double, 3>>(asked, run).point);
  return by_sign(p[0] * p[1]);
}

// ---- callipers ----------------------------------------------------------------------------------------------

double smaller_margin(const Asked& asked, const Run& run) {
  const auto& fact = fact_of<CalipersTurned<double, 3>>(asked, run);
  const FitTrace trace = fit_run(run).trace();
  double before = kNever;
  for (int i = 0; i < asked.fact; ++i)
    if (const auto* turned = std::get_if<CalipersTurned<double, 3>>(&trace[i].step.fact))
      before = std::min(before, turned->area);
  return before == kNever ? kNever : std::abs(fact.area - before) / std::max(fact.area, before);
}

// ---- the passes of an iterative run -------------------------------------------------------------------------

/// The difference between the areas of the two circles, as a share of the larger. Students compare the radii as
/// numbers.
double better_margin(const Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  const auto best = best_before(trace, asked.fact + 1);
  if (!best) return 0;
  const double radius = fit::size_of(trace[asked.fact].step.volume, asked.dim);
  const double ratio = std::min(radius, *best) / std::max(radius, *best);
  return 1 - ratio * ratio;
}

std::optional<Answer> always_better(const Asked&, const Run&) { return by_choice(kYes); }

}  // namespace snug::lesson
