#include "app/captions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "app/numbers.hpp"
#include "app/subjects/scene/frame_caption.hpp"
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
  std::string ball;               // "circle", "sphere"
  const Step3* before = nullptr;  // the step just before; null where it is the first, or not known

  /// Whether the step before it found such a thing.
  template <class Fact>
  [[nodiscard]] bool follows() const {
    return before != nullptr && std::holds_alternative<Fact>(before->fact);
  }

  /// The radius of the step's sphere; 0 where it has none.
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
  [[nodiscard]] std::string outline_word() const { return dim() == 2 ? "outline" : "surface"; }
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
    if (follows<fit::SurfaceFound<double, 3>>())
      return "The centroid of the hull's " + outline_word() + " is (" + where + ").";
    if (const auto* hull = before != nullptr ? std::get_if<fit::HullFound>(&before->fact) : nullptr)
      return "The mean of the hull's " + std::to_string(hull->vertices.size()) + " vertices is (" + where +
             "): no other point counts.";
    return "The mean of all " + counted(fit::size_of(points), "point") + " is (" + where + "): their centre of mass.";
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
    return "The points that reach farthest along each axis set the box's extents: " + lengths + ".";
  }

  std::string operator()(const fit::BallFound<double, 3>& fact) const {
    return "The smallest " + ball + " around the points has radius " + number_text(fact.ball.radius) +
           "; it is supported by " + name_of_points(span_of(fact.support)) + ".";
  }

  std::string operator()(const fit::HullFound& fact) const {
    return "The convex hull has " +
           (fact.vertices.size() == 1 ? "1 vertex" : std::to_string(fact.vertices.size()) + " vertices") + " and " +
           counted(fact.facets, dim() == 2 ? "edge" : "face") + ": no point inside it can touch a box.";
  }

  std::string operator()(const fit::SurfaceFound<double, 3>& fact) const {
    return "The hull's " + outline_word() + " measures " + number_text(fact.area) +
           (dim() == 2 ? " units: every piece of it counts by its length,"
                       : " units²: every piece of it counts by its area,") +
           " however many points lie on it.";
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
    return on + (dim() == 2 ? ": " : ", in the projection along the axis; its box has ") + size_word() +
           number_text(fact.measure) + (fact.better ? ", the smallest so far." : ": no better than before.");
  }

  std::string operator()(const fit::EdgeSearched& fact) const {
    return "Every box with a face on the edge from " + point_name(fact.a) + " to " + point_name(fact.b) +
           " and an adjacent face on one of " + counted(fact.pairs, "other edge") + " is tried or ruled out.";
  }

  std::string operator()(const fit::BoxWidened& fact) const {
    return point_name(fact.point) + " lies outside the box so far: the box is widened to it.";
  }

  std::string operator()(const fit::LineFound& fact) const {
    return "The line along the main axis that lies closest to all points is supported by " +
           name_of_points(fact.support) + ", " + number_text(fact.radius) + " away.";
  }

  std::string operator()(const fit::EndPulledIn& fact) const {
    return std::string(fact.end == 0 ? "The first" : "The second") + " end is pulled in by " + number_text(fact.by) +
           ", until its cap touches " + point_name(fact.point) + ".";
  }

  std::string operator()(const fit::ThicknessFound& fact) const {
    return "The radius is half of their least thickness, " + number_text(fact.radius) + ".";
  }

  std::string operator()(const fit::SidePulledIn& fact) const {
    return "Side " + std::to_string(fact.side + 1) + " of the rectangle is pulled in by " + number_text(fact.by) +
           ", until it touches " + point_name(fact.point) + ".";
  }

  std::string operator()(const fit::CornerMovedOut& fact) const {
    return point_name(fact.point) + " lies outside past a corner of the rectangle: the corner moves out to it.";
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
           (fact.dropped == 1 ? " lies inside and is dropped." : " lie inside and are dropped.");
  }

  std::string operator()(const fit::EyeChosen& fact) const {
    return point_name(fact.point) + " is farthest from its facet, by " + number_text(fact.distance) +
           ": it is a vertex of the hull.";
  }

  std::string operator()(const fit::EdgeSplit& fact) const {
    return "The edge from " + point_name(fact.a) + " to " + point_name(fact.b) + " is replaced by two, which meet at " +
           point_name(fact.point) + ".";
  }

  std::string operator()(const fit::HorizonFound& fact) const {
    return point_name(fact.eye) + " sees " + counted(static_cast<std::int64_t>(fact.facets.size()), "facet") +
           "; their boundary is the horizon.";
  }

  std::string operator()(const fit::FacetsReplaced& fact) const {
    return counted(static_cast<std::int64_t>(fact.removed.size()), "facet") + " are replaced by " +
           std::to_string(fact.added.size()) + " new ones, from the horizon to " + point_name(fact.eye) + ".";
  }

  std::string operator()(const fit::FacesMerged& fact) const {
    return "Facets in one plane become one face: " + counted(fact.faces, "face") + ", and " +
           counted(static_cast<std::int64_t>(fact.dropped.size()), "point") + " inside them " +
           (fact.dropped.size() == 1 ? "is no vertex." : "are no vertices.");
  }

  std::string operator()(const query::FramesRelated<double, 3>&) const {
    return "B is expressed in A's frame, where A is axis-aligned and its face axes are x" +
           std::string(dim() == 2 ? " and y." : ", y and z.");
  }

  std::string operator()(const query::AxisTested<double, 3>& fact) const {
    const std::string axis = lesson::axis_text(dim(), fact.axis);
    if (fact.skipped) return "Along " + axis + " there is nothing to test: the edges are parallel.";
    const std::string sum = "r_A + r_B = " + number_text(fact.radius_a) + " + " + number_text(fact.radius_b);
    return "Along " + axis + " the distance " + number_text(fact.distance) +
           (fact.separates ? " is greater than " + sum + ": a gap, so the boxes are apart."
                           : " is not greater than " + sum + ": no gap.");
  }

  std::string operator()(const query::LookedCloser& fact) const {
    return "Too close to call for rounded numbers: " + std::to_string(fact.axes) +
           (fact.axes == 1 ? " axis is" : " axes are") + " tested again in exact arithmetic.";
  }

  std::string operator()(const query::OutlinesCompared& fact) const {
    return "Along " + direction_name(fact.axis) + " the extents of the two AABBs " +
           (fact.apart ? "are disjoint." : "overlap.");
  }

  std::string operator()(const query::CornerTried& fact) const {
    const char* other = fact.box == 0 ? "B" : "A";
    const std::string corner =
        lesson::place_name(dim(), lesson::index_of(dim(), {lesson::Place::Kind::kCorner, fact.box, fact.corner}));
    return "Vertex " + corner + (fact.inside ? " lies inside " : " lies outside ") + other + ".";
  }

  std::string operator()(const query::Claimed& fact) const {
    return std::string("This test says that the boxes ") + (fact.overlap ? "overlap" : "are apart") +
           "; the proof tells whether it is right.";
  }

  std::string operator()(const query::Verdict<double, 3>& fact) const {
    const auto& [overlap, tests, axis] = fact.result;
    const std::string name = lesson::axis_text(dim(), axis);
    const std::string all = std::to_string(lesson::axis_names(dim()).size());
    if (overlap)
      return "Overlap: none of the " + all + " axes separates the boxes" +
             (name.empty()
                  ? "."
                  : "; penetration is least along " + name + ", " + number_text(std::max(0.0, -axis.gap)) + ".");
    return "Apart: along " + name + " there is a gap" + (axis.gap > 0 ? " of " + number_text(axis.gap) : "") + "; " +
           std::to_string(tests) + " of " + all + " axes were tested.";
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
    if (fact.skipped) return plane(fact.plane) + "skipped, since the parent is inside it.";
    if (fact.looked_closer)
      return plane(fact.plane) + "a vertex is too close to it for rounded numbers; exact arithmetic says " +
             std::string(query::kCullingNames[static_cast<std::size_t>(fact.side)]) + ".";
    if (fact.side == Culling::kOutside)
      return plane(fact.plane) + "even the " + n + " is outside, by " + n_by + ", so the whole box is.";
    if (fact.side == Culling::kInside)
      return plane(fact.plane) + "even the " + p + " is inside, by " + p_by + ", so the whole box is.";
    return plane(fact.plane) + "the " + p + " is outside by " + p_by + " and the " + n + " inside by " + n_by +
           ", so the box crosses it.";
  }

  std::string operator()(const query::CornerTested<double, 3>& fact) const {
    const std::string corner = "Vertex " + lesson::sign_name(dim(), fact.corner);
    if (fact.plane < 0) return corner + " is inside every plane, so it lies in the frustum.";
    const std::string by = fact.distance == 0 ? "" : ", by " + short_figure(std::abs(fact.distance));
    return corner + (fact.outside ? " is outside the " : " is inside the ") + lesson::plane_name(dim(), fact.plane) +
           " plane" + by + ".";
  }

  std::string operator()(const query::Classified& fact) const {
    using query::Culling;
    const query::CullResult& result = fact.result;
    if (result.rejected_by >= 0)
      return "Outside: the whole box is beyond the " + lesson::plane_name(dim(), result.rejected_by) + " plane; " +
             counted(result.planes_tested, "plane") + (result.planes_tested == 1 ? " was" : " were") + " tested.";
    if (result.verdict == Culling::kOutside)
      return "No vertex lies in the frustum, so this test says outside; the proof tells whether it is right.";
    if (result.verdict == Culling::kInside) return "Inside: every vertex of the box is inside every plane.";
    if (result.crossing == 0) return "Intersecting: some vertices lie in the frustum and some do not.";
    return "Intersecting: the box crosses " + lesson::plane_names(dim(), result.crossing) +
           " and is wholly outside none.";
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
                       std::optional<double> best_before, const Step3* before) {
  return std::visit(Sayer{step, next, points, exact, best_before, lesson::ball_word(fit::dim_of(points)), before},
                    step.fact);
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
  if (entry == nullptr && session.lesson().scene) {
    const bool bodies = session.lesson().scene->at_points();
    return std::string(session.algorithm(0)->title) + ", " +
           (bodies && session.size() != 1 ? std::to_string(session.size()) + " bodies"
            : bodies                      ? "1 body"
                                          : "a body of " + counted(session.size(), "point")) +
           ": nothing has moved yet. Go to frame 1.";
  }
  if (entry == nullptr) return caption_at_start(*session.algorithm(0), session.size());
  if (const auto* frame = std::get_if<fit::FrameTaken>(&entry->step.fact)) return frame_caption(*frame, &session);
  const auto& steps = session.recording(0).steps;
  const auto next = static_cast<std::size_t>(session.step());
  return caption_of(entry->step, next < steps.size() ? &steps[next].step : nullptr, session.points(),
                    session.algorithm(0)->exact, lesson::best_before(steps, session.step()),
                    next > 1 ? &steps[next - 2].step : nullptr);
}

}  // namespace snug::app
