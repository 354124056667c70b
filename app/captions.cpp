#include "app/captions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "app/numbers.hpp"
#include "app/scene_panel.hpp"
#include "lesson/ask.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/figures.hpp"
#include "lesson/frustum_box.hpp"
#include "lesson/passes.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

using fit::Step3;
using fit::Support;
using lesson::number_text;
using lesson::point_name;
using Point = Vector<double, 3>;

std::string counted(std::int64_t n, const char* thing) { return std::to_string(n) + " " + thing + (n == 1 ? "" : "s"); }

std::string direction_name(int axis) {
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  return kNames[axis];
}

std::span<const Index> span_of(const Support& support) {
  return {support.begin(), static_cast<std::size_t>(support.size())};
}
std::span<const Index> span_of(const std::vector<Index>& support) { return support; }

/// Says each fact. One overload per fact, so that a new one does not compile before it has its sentence.
struct Sayer {
  const Step3& step;
  const Step3* next;
  const AnyPointSet& points;
  bool exact;
  std::optional<double> best_before;
  std::string ball;  // "circle", "sphere"

  /// Of the ball that the step has; 0 where it has none.
  [[nodiscard]] double radius() const {
    const fit::Sphere3* own = ball_of(step);
    return own != nullptr ? own->radius : 0;
  }
  /// "radius 2.1", "area 3.4"
  [[nodiscard]] std::string size() const {
    if (ball_of(step) != nullptr) return "radius " + number_text(radius());
    return size_word() + number_text(fit::size_of(step.volume, dim()));
  }
  [[nodiscard]] std::string size_word() const { return dim() == 2 ? "area " : "volume "; }
  [[nodiscard]] int dim() const { return fit::dim_of(points); }
  [[nodiscard]] Point at(Index i) const { return fit::point_of(points, i); }

  std::string operator()(const fit::ExtremesFound<double, 3>&) const {
    const char* sides = dim() == 2 ? "leftmost, rightmost, lowest and highest" : "least and greatest";
    return std::string("The extreme points are found: the ") + sides +
           (dim() == 2 ? "." : " along each of the three axes.");
  }

  std::string operator()(const fit::FrameTaken& fact) const { return frame_caption(fact, nullptr); }

  std::string operator()(const fit::MidpointFound<double, 3>& fact) const {
    const Point widths = fact.greatest - fact.least;
    std::string size = number_text(widths[0]) + " × " + number_text(widths[1]);
    if (dim() == 3) size += " × " + number_text(widths[2]);
    return "The AABB of all points is " + size + "; its centre becomes the centre of the " + ball + ".";
  }

  std::string operator()(const fit::PairChosen& fact) const {
    const std::string pair = point_name(fact.a) + " and " + point_name(fact.b);
    if (!step.has_volume) return pair + " lie farthest out along the main axis, one on each side.";
    const std::string why = fact.axis == kNoIndex ? ", the extremes along the main axis, are"
                                                  : ", the extremes along " + direction_name(fact.axis) +
                                                        ", are the pair farthest apart. They are";
    return pair + why + " the ends of the first diameter, " + number_text(fact.distance) + " long.";
  }

  std::string operator()(const fit::FarthestFound& fact) const {
    return point_name(fact.point) + " is farthest from the centre, at " + number_text(fact.distance) +
           ", so it sets the radius.";
  }

  std::string operator()(const fit::PointExamined& fact) const {
    const std::string point = point_name(fact.point);
    if (!step.has_volume) return point + " is the first point: there is no " + ball + " yet to contain it.";
    const double gap = fact.distance - radius();
    const bool forced = next != nullptr && std::holds_alternative<fit::BoundaryForced>(next->fact);
    if (!fact.outside)
      return point + " lies inside" + (gap < 0 ? " by " + short_figure(-gap) : "") + ": nothing changes.";
    return point + " lies outside by " + short_figure(gap) +
           (forced ? ", so it must be on the boundary of the next " + ball + "." : ".");
  }

  std::string operator()(const fit::BallGrown<double, 3>& fact) const {
    const double gap = (at(fact.point) - fact.before.center).norm() - fact.before.radius;
    return point_name(fact.point) + " lies outside by " + short_figure(gap) + ", so the " + ball +
           " grows to take it in.";
  }

  std::string operator()(const fit::MeanFound<double, 3>& fact) const {
    std::string where = number_text(fact.mean[0]) + ", " + number_text(fact.mean[1]);
    if (dim() == 3) where += ", " + number_text(fact.mean[2]);
    return "The mean of all " + counted(fit::size_of(points), "point") + " is their balance point: (" + where + ").";
  }

  std::string operator()(const fit::CovarianceFound<double, 3>&) const {
    return std::string("The covariance matrix says how the points spread about the mean. The ") +
           (dim() == 2 ? "ellipses are" : "ellipsoids are") + " drawn at one and two standard deviations.";
  }

  std::string operator()(const fit::AxesFound<double, 3>& fact) const {
    const double most = std::sqrt(std::max(fact.variances[2], 0.0));
    return std::string("The eigenvectors are the axes of the ") + (dim() == 2 ? "ellipse" : "ellipsoid") +
           ". The points spread most along the longest, with σ = " + number_text(most) + ".";
  }

  std::string operator()(const fit::BallShrunk<double, 3>& fact) const {
    return "Pass " + std::to_string(fact.pass) + ": the radius shrinks by 5 % to " + number_text(radius()) +
           ", and the points are shuffled.";
  }

  std::string operator()(const fit::PassJudged<double, 3>& fact) const {
    const std::string pass = "Pass " + std::to_string(fact.pass) + " ends at ";
    if (fact.better && best_before) {
      const auto [own, before] = lesson::number_texts_apart(radius(), *best_before);
      if (own != before) return pass + own + ", smaller than the best so far, " + before + ": it is kept.";
    }
    if (fact.better) return pass + number_text(radius()) + ", the smallest so far: it is kept.";
    const auto [own, best] = lesson::number_texts_apart(radius(), fact.best.radius);
    if (own == best) return pass + own + ", as large as the best so far: it is dropped.";
    return pass + own + ", larger than the best so far, " + best + ": it is dropped.";
  }

  std::string operator()(const fit::BoundaryForced& fact) const {
    const std::string names = name_of_points(span_of(fact.boundary));
    const std::string call = "A call begins with " + names + " on the boundary: ";
    if (fact.boundary.size() == 1) return call + "the " + ball + " is that point alone.";
    return call + "the smallest " + ball + " through them has radius " + number_text(radius()) + ".";
  }

  std::string operator()(const fit::MovedToFront& fact) const {
    return point_name(fact.point) + " moves to the front of the list, and the call that waited for it goes on.";
  }

  std::string operator()(const fit::AllChecked& fact) const {
    if (fact.outside == 0) return "All points are tested against the " + ball + ": none lies outside.";
    return "All points are tested against the " + ball + ": " + counted(fact.outside, "candidate") +
           (fact.outside == 1 ? " lies outside." : " lie outside.");
  }

  std::string operator()(const fit::RadiusChecked& fact) const {
    return "The last check, in exact arithmetic: " + point_name(fact.farthest) + " is farthest out, " +
           (fact.widened ? "and the radius grows in its last digit to contain it."
                         : "and the " + ball + " contains it.");
  }

  std::string operator()(const fit::SupportReplaced& fact) const {
    Support gone;
    for (const Index i : fact.before)
      if (!fact.after.contains(i)) gone.add(i);
    const std::string left =
        gone.size() == 0 ? "" : name_of_points(span_of(gone)) + (gone.size() == 1 ? " leaves" : " leave");
    if (fact.entered == kNoIndex)
      return (left.empty() ? "The support set is solved again" : left + " the support set") +
             ": the other points support the " + ball + " alone.";
    return point_name(fact.entered) + " joins the support set" +
           (left.empty() ? ", and none leaves it." : ", and " + left + " it.");
  }

  std::string operator()(const fit::CandidateTried<double, 3>& fact) const {
    using Verdict = fit::CandidateTried<double, 3>::Verdict;
    const std::string names = name_of_points(span_of(fact.points));
    const std::string tried = "The " + ball + " of " + names;
    switch (fact.verdict) {
      case Verdict::kKept:
        return tried + " contains all points and is the smallest so far, " + number_text(fact.candidate.radius) +
               ": it is kept.";
      case Verdict::kNotSmaller: return tried + " is no smaller than the best: no point needs testing.";
      case Verdict::kLeavesPointOutside:
        return tried + " leaves " + point_name(fact.outside) + " outside: it is dropped.";
      case Verdict::kNoBall: break;
    }
    return "The smallest " + ball + " around " + names + " is supported by fewer of them: it is no new candidate.";
  }

  std::string operator()(const fit::ExtentsFound<double, 3>& fact) const {
    std::string lengths;
    for (int i = 0; i < dim(); ++i) lengths += (i > 0 ? " × " : "") + number_text(fact.lengths[i]);
    return "The points that reach farthest along each axis set the box: " + lengths + ".";
  }

  std::string operator()(const fit::BallFound<double, 3>& fact) const {
    return "The smallest " + ball + " around the points has radius " + number_text(fact.ball.radius) +
           "; it is supported by " + name_of_points(span_of(fact.support)) + ".";
  }

  std::string operator()(const fit::HullFound& fact) const {
    return "The convex hull has " + counted(static_cast<std::int64_t>(fact.vertices.size()), "corner") + " and " +
           counted(fact.facets, dim() == 2 ? "edge" : "face") + ": no other point can touch a box.";
  }

  std::string operator()(const fit::SurfaceFound<double, 3>& fact) const {
    return std::string("The hull's ") + (dim() == 2 ? "outline is " : "surface is ") + number_text(fact.area) +
           (dim() == 2 ? " units long" : " units²") +
           ": each bit of it weighs the same, however many points lie on it.";
  }

  std::string operator()(const fit::PointsChosen& fact) const {
    return name_of_points(span_of(fact.points)) + (fact.points.size() == 1 ? " is" : " are") +
           " chosen: the axes are built on " + (fact.points.size() == 1 ? "it." : "them.");
  }

  std::string operator()(const fit::BoxTried<double, 3>& fact) const {
    const std::string on = fact.on.empty() ? "A box" : "The box on " + name_of_points(span_of(fact.on));
    return on + " has " + size_word() + number_text(fact.measure) +
           (fact.better ? ", the smallest so far: it is kept." : ", no smaller than the best: it is dropped.");
  }

  std::string operator()(const fit::RectangleFound<double, 3>& fact) const {
    const std::string on = fact.edge_a == kNoIndex ? "The smallest rectangle"
                                                   : "The smallest rectangle lies on the hull's edge from " +
                                                         point_name(fact.edge_a) + " to " + point_name(fact.edge_b);
    return on + (dim() == 2 ? ": " : ", seen along the axis; its box has ") + size_word() + number_text(fact.measure) +
           (fact.better ? ", the smallest so far." : ": no better than before.");
  }

  std::string operator()(const fit::EdgeSearched& fact) const {
    return "Every box with a face on the edge from " + point_name(fact.a) + " to " + point_name(fact.b) +
           " is ruled out or tried, with " + counted(fact.pairs, "second edge") + ".";
  }

  std::string operator()(const fit::BoxWidened& fact) const {
    return point_name(fact.point) + " lies outside the box so far, which widens to it.";
  }

  std::string operator()(const fit::LineFound& fact) const {
    return "The line along the main axis that lies closest to all points is held by " + name_of_points(fact.support) +
           ", at " + number_text(fact.radius) + ".";
  }

  std::string operator()(const fit::EndPulledIn& fact) const {
    return std::string(fact.end == 0 ? "The first" : "The second") + " end is pulled in by " + number_text(fact.by) +
           ", until its cap touches " + point_name(fact.point) + ".";
  }

  std::string operator()(const fit::ThicknessFound& fact) const {
    return "Where the points are thinnest their half is the radius, " + number_text(fact.radius) + ".";
  }

  std::string operator()(const fit::SidePulledIn& fact) const {
    return "Side " + std::to_string(fact.side + 1) + " of the rectangle is pulled in by " + number_text(fact.by) +
           ", until " + point_name(fact.point) + " is touched.";
  }

  std::string operator()(const fit::CornerMovedOut& fact) const {
    return point_name(fact.point) + " lies past a corner, which moves out to it.";
  }

  std::string operator()(const fit::SlabFound& fact) const {
    return "Slab " + std::to_string(fact.slab + 1) + " lies between " + point_name(fact.least) + " and " +
           point_name(fact.greatest) + ", the extremes along its axis.";
  }

  std::string operator()(const fit::SimplexChosen& fact) const {
    return std::string(dim() == 2 ? "A segment" : "A tetrahedron") +
           " is the first hull: " + name_of_points(fact.points) + ".";
  }

  std::string operator()(const fit::FlatFound& fact) const {
    constexpr std::array<const char*, 3> kWhere{"in one place", "on one line", "in one plane"};
    return std::string("All points lie ") + kWhere[fact.affine_dim] + ".";
  }

  std::string operator()(const fit::PointsAssigned& fact) const {
    std::int64_t outside = 0;
    for (const Index count : fact.counts) outside += count;
    return counted(outside, "point") + (outside == 1 ? " is" : " are") + " given to the facets that see them; " +
           counted(fact.dropped, "point") +
           (fact.dropped == 1 ? " lies inside and is done with." : " lie inside and are done with.");
  }

  std::string operator()(const fit::EyeChosen& fact) const {
    return point_name(fact.point) + " is farthest from its facet, by " + number_text(fact.distance) +
           ": it is a corner of the hull.";
  }

  std::string operator()(const fit::EdgeSplit& fact) const {
    return "The edge from " + point_name(fact.a) + " to " + point_name(fact.b) + " gives way to two, by way of " +
           point_name(fact.point) + ".";
  }

  std::string operator()(const fit::HorizonFound& fact) const {
    return point_name(fact.eye) + " sees " + counted(static_cast<std::int64_t>(fact.facets.size()), "facet") +
           "; their border is its horizon.";
  }

  std::string operator()(const fit::FacetsReplaced& fact) const {
    return counted(static_cast<std::int64_t>(fact.removed.size()), "facet") + " give way to " +
           std::to_string(fact.added.size()) + " new ones, from the horizon to " + point_name(fact.eye) + ".";
  }

  std::string operator()(const fit::FacesMerged& fact) const {
    return "Facets in one plane become one face: " + counted(fact.faces, "face") + ", and " +
           counted(static_cast<std::int64_t>(fact.dropped.size()), "point") + " inside them are no corners.";
  }

  std::string operator()(const query::FramesRelated<double, 3>&) const {
    return "B is written in A's own frame: from there A is a plain box, and its axes are x" +
           std::string(dim() == 2 ? " and y." : ", y and z.");
  }

  std::string operator()(const query::AxisTested<double, 3>& fact) const {
    const std::string axis = lesson::axis_names(dim())[lesson::axis_index(dim(), fact.axis)].text;
    if (fact.skipped) return axis + ": these edges are parallel, so they have no axis of their own.";
    const std::string sum = number_text(fact.radius_a) + " + " + number_text(fact.radius_b);
    if (fact.separates)
      return "Along " + axis + " the centres are " + number_text(fact.distance) + " apart, more than " + sum +
             ": there is a gap, so the boxes are apart.";
    return "Along " + axis + " the centres are " + number_text(fact.distance) + " apart, no more than " + sum +
           ": this axis does not separate them.";
  }

  std::string operator()(const query::LookedCloser& fact) const {
    return "The numbers are too close to call: " + std::to_string(fact.axes) + (fact.axes == 1 ? " axis" : " axes") +
           (fact.axes == 1 ? " is" : " are") + " looked at again in exact arithmetic.";
  }

  std::string operator()(const query::OutlinesCompared& fact) const {
    return "Along " + direction_name(fact.axis) + " the upright outlines " + (fact.apart ? "do not meet." : "meet.");
  }

  std::string operator()(const query::CornerTried& fact) const {
    const char* other = fact.box == 0 ? "B" : "A";
    const std::string corner =
        lesson::place_name(dim(), lesson::index_of(dim(), {lesson::Place::Kind::kCorner, fact.box, fact.corner}));
    return "Corner " + corner + (fact.inside ? " lies in box " : " is not in box ") + other + ".";
  }

  std::string operator()(const query::Claimed& fact) const {
    return std::string("This test says: the boxes ") + (fact.overlap ? "overlap." : "are apart.") +
           " The proof beside it says whether that is so.";
  }

  std::string operator()(const query::Verdict<double, 3>& fact) const {
    const std::string after =
        " after " + std::to_string(fact.result.tests) + (fact.result.tests == 1 ? " axis." : " axes.");
    return (fact.result.overlap ? "Overlap: no axis separates the boxes,"
                                : "Apart: one axis that separates them is enough,") +
           after;
  }

  /// "Left plane: …"
  [[nodiscard]] std::string plane(int at) const {
    std::string name = lesson::plane_name(dim(), at);
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return name + " plane: ";
  }

  std::string operator()(const query::PlaneTested<double, 3>& fact) const {
    using query::Culling;
    const std::string p = "p-vertex " + lesson::sign_name(dim(), fact.p_vertex),
                      n = "n-vertex " + lesson::sign_name(dim(), fact.n_vertex);
    const std::string p_by = short_figure(std::abs(fact.p_distance)), n_by = short_figure(std::abs(fact.n_distance));
    if (fact.skipped) return plane(fact.plane) + "it is skipped, for the box is known to be inside of it.";
    if (fact.looked_closer)
      return plane(fact.plane) + "a vertex is too close to it for rounded numbers; exact ones say " +
             std::string(query::kCullingNames[static_cast<std::size_t>(fact.side)]) + ".";
    if (fact.side == Culling::kOutside)
      return plane(fact.plane) + "even the " + n + " is outside, by " + n_by + ", so all of the box is.";
    if (fact.side == Culling::kInside)
      return plane(fact.plane) + "even the " + p + " is inside, by " + p_by + ", so all of the box is.";
    return plane(fact.plane) + "the " + p + " is outside by " + p_by + ", the " + n + " inside by " + n_by +
           ": the box crosses it.";
  }

  std::string operator()(const query::CornerTested<double, 3>& fact) const {
    const std::string corner = "Corner " + lesson::sign_name(dim(), fact.corner);
    if (fact.plane < 0) return corner + " is outside of no plane: it can be seen.";
    const std::string by = fact.distance == 0 ? "" : ", by " + short_figure(std::abs(fact.distance));
    return corner + (fact.outside ? " is outside of the " : " is inside of the ") +
           lesson::plane_name(dim(), fact.plane) + " plane" + by + ".";
  }

  std::string operator()(const query::Classified& fact) const {
    using query::Culling;
    const query::CullResult& result = fact.result;
    if (result.rejected_by >= 0)
      return "Outside: all of the box is beyond the " + lesson::plane_name(dim(), result.rejected_by) +
             " plane, found after " + counted(result.planes_tested, "plane") + ".";
    if (result.verdict == Culling::kOutside)
      return "No corner can be seen, so this test says outside. The proof beside it says whether that is so.";
    if (result.verdict == Culling::kInside) return "Inside: every corner of the box is inside of every plane.";
    if (result.crossing == 0) return "Intersecting: some corners can be seen, and some cannot.";
    return "Intersecting: the box crosses " + lesson::plane_names(dim(), result.crossing) +
           ", and no plane has all of it outside.";
  }

  std::string operator()(const fit::Finished& fact) const {
    // The iterative method starts from Ritter's result: the same fact, but not the end.
    if (next != nullptr) return "It starts from Ritter's " + ball + ", with radius " + number_text(radius()) + ".";
    const std::string done = "Done: " + size(), names = name_of_points(span_of(fact.support));
    return exact ? done + ", supported by " + names + "." : done + "; it touches " + names + ".";
  }
};

}  // namespace

std::string name_of_points(std::span<const Index> points) {
  if (points.empty()) return "no point";
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i + 1 == points.size() ? " and " : ", ";
    text += lesson::point_name(points[i]);
  }
  return text;
}

std::string caption_of(const Step3& step, const Step3* next, const AnyPointSet& points, bool exact,
                       std::optional<double> best_before) {
  return std::visit(Sayer{step, next, points, exact, best_before, lesson::ball_word(fit::dim_of(points))}, step.fact);
}

std::string caption_at_start(const fit::Algorithm& algorithm, Index points) {
  return std::string(algorithm.title) + " on " + counted(points, "point") +
         ": nothing is known yet. Take the first step.";
}

std::string caption_at(const lesson::Session& session) {
  const auto* entry = session.current(0);
  if (entry == nullptr && session.boxes() != nullptr)
    return std::string(session.algorithm(0)->title) +
           (lesson::has_frustum(*session.boxes()) ? " on the box and the frustum" : " on the boxes A and B") +
           ": nothing is known yet. Take the first step.";
  if (entry == nullptr && session.lesson().scene && session.lesson().scene->at_points())
    return std::string(session.algorithm(0)->title) + " on " + std::to_string(session.size()) +
           (session.size() == 1 ? " body" : " bodies") + ": nothing has moved yet. Take the first step.";
  if (entry == nullptr) return caption_at_start(*session.algorithm(0), session.size());
  if (const auto* frame = std::get_if<fit::FrameTaken>(&entry->step.fact)) return frame_caption(*frame, &session);
  const auto& steps = session.recording(0).steps;
  const auto next = static_cast<std::size_t>(session.step());
  return caption_of(entry->step, next < steps.size() ? &steps[next].step : nullptr, session.points(),
                    session.algorithm(0)->exact, lesson::best_before(steps, session.step()));
}

}  // namespace snug::app
