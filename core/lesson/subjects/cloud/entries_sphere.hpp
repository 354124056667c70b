// The entries of the facts that sphere fitters report, and of those that they share with other fitters.
#pragma once

#include <algorithm>
#include <cmath>

#include "lesson/point_subject.hpp"
#include "lesson/subjects/cloud/facet_asks.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/subjects/cloud/passes.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {

using FitWhere = FitRun::Where;

/// "3 points"
[[nodiscard]] inline std::string counted(std::int64_t n, const char* thing) {
  return count_text(n) + " " + thing + (n == 1 ? "" : "s");
}

[[nodiscard]] inline std::vector<Index> list_of(const auto& points) { return {points.begin(), points.end()}; }

/// A fact's points without kNoIndex, each once.
[[nodiscard]] inline std::vector<Index> points_of(std::initializer_list<std::span<const Index>> some) {
  std::vector<Index> all;
  for (const std::span<const Index> points : some)
    for (const Index i : points)
      if (i != kNoIndex && std::find(all.begin(), all.end(), i) == all.end()) all.push_back(i);
  return all;
}

template <>
struct Entry<fit::ExtremesFound<double, 3>> : FitEntry {
  using Fact = fit::ExtremesFound<double, 3>;
  static constexpr std::array kQuestionKinds{kExtremes, kGrows};
  static std::string sentence(const Fact&, const FitWhere& where) {
    const bool plane = where.dim() == 2;
    return std::string("The extreme points are found: the ") +
           (plane ? "leftmost, rightmost, lowest and highest." : "least and greatest along each of the three axes.");
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return points_of({fact.least, fact.greatest});
  }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "reach farthest along the axes"; }
};

template <>
struct Entry<fit::MidpointFound<double, 3>> : FitEntry {
  static std::string sentence(const fit::MidpointFound<double, 3>& fact, const FitWhere& where) {
    const Point3 widths = fact.greatest - fact.least;
    std::string size = number_text(widths[0]) + " × " + number_text(widths[1]);
    if (where.dim() == 3) size += " × " + number_text(widths[2]);
    return "The AABB of all points is " + size + "; its centre becomes the centre of the " + where.ball() + ".";
  }
};

template <>
struct Entry<fit::PairChosen> : FitEntry {
  using Fact = fit::PairChosen;
  static constexpr std::array kQuestionKinds{kAxis, kExtremes, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string pair = where.name(fact.a) + " and " + where.name(fact.b);
    const fit::Step3* before = where.before();
    if (before != nullptr && std::holds_alternative<fit::BallFound<double, 3>>(before->fact))
      return pair + " are the points of the support set that lie farthest apart: an axis runs through them.";
    if (!where.step().has_volume) return pair + " lie farthest out along the main axis, one on each side.";
    const std::string why = fact.axis == kNoIndex ? ", the extremes along the main axis, are"
                                                  : std::string(", the extremes along ") + "xyz"[fact.axis] +
                                                        ", are the pair farthest apart. They are";
    return pair + why + " the ends of the first diameter, " + number_text(fact.distance) + " long.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.a, fact.b}; }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "are chosen" : "is chosen";
  }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return {{fact.a, fact.b}}; }
};

template <>
struct Entry<fit::FarthestFound> : FitEntry {
  using Fact = fit::FarthestFound;
  static constexpr std::array kQuestionKinds{kFarthest, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return where.name(fact.point) + " is farthest from the centre, at " + number_text(fact.distance) +
           ", so it sets the radius.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "is the farthest"; }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return {{fact.point}}; }
};

template <>
struct Entry<fit::PointExamined> : FitEntry {
  using Fact = fit::PointExamined;
  static constexpr std::array kQuestionKinds{kSide, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string point = where.name(fact.point);
    if (!where.step().has_volume)
      return point + " is the first point: there is no " + where.ball() + " yet to contain it.";
    return said(fact, where, point) + where.contradiction();
  }
  static std::string said(const Fact& fact, const FitWhere& where, const std::string& point) {
    const double gap = fact.distance - where.radius();
    const bool forced = where.next() != nullptr && std::holds_alternative<fit::BoundaryForced>(where.next()->fact);
    if (!fact.outside) return point + " lies " + place_of(gap, where) + ": nothing changes.";
    return point + " lies outside by " + number_text(gap) +
           (forced ? ", so it must be on the boundary of the next " + where.ball() + "." : ".");
  }
  /// Where a point is that changes nothing. gap: how far beyond the boundary; above 0 if rounding or an epsilon hides
  /// it.
  static std::string place_of(double gap, const FitWhere& where) {
    if (gap == 0) return "on the " + where.ball();
    return gap < 0 ? "inside by " + number_text(-gap) : "inside";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere& where) {
    return where.is_first_wrong() ? std::optional(Mark::Kind::kWrong) : first(where);
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere& where, bool) {
    return "is tested against the " + where.ball();
  }
};

template <>
struct Entry<fit::BallGrown<double, 3>> : FitEntry {
  using Fact = fit::BallGrown<double, 3>;
  static constexpr std::array kQuestionKinds{kNextOutside, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string gap = where.run.is_rounding(where.i) ? "no more than rounding"
                                                           : number_text(where.run.gap_to(fact.point, fact.before));
    return where.name(fact.point) + " lies outside by " + gap + ", so the " + where.ball() + " grows to contain it.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere& where, bool) {
    return "lies outside, and the " + where.ball() + " grows to it";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere&) { return Mark::Kind::kGrew; }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return {{fact.point}}; }
};

template <>
struct Entry<fit::MeanFound<double, 3>> : FitEntry {
  static std::string sentence(const fit::MeanFound<double, 3>& fact, const FitWhere& where) {
    std::string at = coordinate_text(fact.mean[0]) + ", " + coordinate_text(fact.mean[1]);
    if (where.dim() == 3) at += ", " + coordinate_text(fact.mean[2]);
    const fit::Step3* before = where.before();
    if (before != nullptr && std::holds_alternative<fit::SurfaceFound<double, 3>>(before->fact))
      return "The centroid of the hull's " + where.outline_word() + " is (" + at + ").";
    if (const auto* hull = before != nullptr ? std::get_if<fit::HullFound>(&before->fact) : nullptr)
      return "The mean of the hull's " + count_text(static_cast<std::int64_t>(hull->vertices.size())) +
             " vertices is (" + at + "): no other point counts.";
    return "The mean of all " + counted(fit::count_of(where.run.points()), "point") + " is (" + at +
           "): their centre of mass.";
  }
};

template <>
struct Entry<fit::CovarianceFound<double, 3>> : FitEntry {
  static std::string sentence(const fit::CovarianceFound<double, 3>&, const FitWhere& where) {
    return std::string("The covariance matrix describes the spread about the mean. The ") +
           (where.dim() == 2 ? "ellipses are" : "ellipsoids are") + " drawn at one and two standard deviations.";
  }
};

template <>
struct Entry<fit::AxesFound<double, 3>> : FitEntry {
  static std::string sentence(const fit::AxesFound<double, 3>& fact, const FitWhere& where) {
    const double most = std::sqrt(std::max(fact.variances[2], 0.0));
    return std::string("The eigenvectors are the axes of the ") + (where.dim() == 2 ? "ellipse" : "ellipsoid") +
           ". The spread is greatest along the longest, with σ = " + number_text(most) + ".";
  }
};

template <>
struct Entry<fit::BallShrunk<double, 3>> : FitEntry {
  using Fact = fit::BallShrunk<double, 3>;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "Pass " + std::to_string(fact.pass) + ": the radius shrinks by 5 % to " + number_text(where.radius()) +
           ", and the points are shuffled.";
  }
  static std::optional<std::vector<Index>> support(const Fact&) { return {std::vector<Index>{}}; }
};

template <>
struct Entry<fit::PassJudged<double, 3>> : FitEntry {
  using Fact = fit::PassJudged<double, 3>;
  static constexpr std::array kQuestionKinds{kBetter, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string pass = "Pass " + std::to_string(fact.pass) + " ends at ";
    const auto best_until = best_before(where.run.trace(), where.i + 1);
    if (fact.better && best_until) {
      const auto [own, before] = number_texts_apart(where.radius(), *best_until);
      if (own == before) return pass + own + ", smaller than the best so far only by rounding: it is kept.";
      return pass + own + ", smaller than the best so far, " + before + ": it is kept.";
    }
    if (fact.better) return pass + number_text(where.radius()) + ", the smallest so far: it is kept.";
    const auto [own, best] = number_texts_apart(where.radius(), fact.best.radius);
    if (own == best) return pass + own + ", as large as the best so far: it is dropped.";
    return pass + own + ", larger than the best so far, " + best + ": it is dropped.";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) { return best_if(fact.better, where); }
};

template <>
struct Entry<fit::BoundaryForced> : FitEntry {
  using Fact = fit::BoundaryForced;
  static constexpr std::array kQuestionKinds{kLeaves, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string call = "A call begins with " + where.names(list_of(fact.boundary)) + " on the boundary: ";
    if (fact.boundary.size() == 1) return call + "the " + where.ball() + " is that point alone.";
    return call + "the smallest " + where.ball() + " through them has radius " + number_text(where.radius()) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return {fact.boundary[fact.boundary.size() - 1]};
  }
  static std::string predicate(const Fact&, const FitWhere& where, bool) {
    return "lies outside, so the next " + where.ball() + " passes through it";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) {
    return fact.depth == 1 ? std::optional(Mark::Kind::kReplaced) : first(where);
  }
  /// Only the outermost calls count: there, a point lies outside the smallest ball of all points before it.
  static bool counts(const Fact& fact) { return fact.depth == 1; }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return fact.boundary.list(); }
};

template <>
struct Entry<fit::MovedToFront> : FitEntry {
  using Fact = fit::MovedToFront;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return where.name(fact.point) + " moves to the front of the list, and the call that waited for it goes on.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "moves to the front"; }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) {
    return fact.depth == 0 ? std::optional(Mark::Kind::kGrew) : first(where);
  }
  static bool counts(const Fact& fact) { return fact.depth == 0; }
};

template <>
struct Entry<fit::AllChecked> : FitEntry {
  static std::string sentence(const fit::AllChecked& fact, const FitWhere& where) {
    const std::string tested = "All points are tested against the " + where.ball() + ": ";
    if (fact.outside == 0) return tested + "none lies outside.";
    return tested + "at least " + counted(fact.outside, "point") +
           (fact.outside == 1 ? " lies outside." : " lie outside.");
  }
};

template <>
struct Entry<fit::RadiusChecked> : FitEntry {
  using Fact = fit::RadiusChecked;
  static constexpr std::array kQuestionKinds{kNextOutside, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    if (where.before() == nullptr)  // the core was set by hand
      return where.name(fact.farthest) + " is the farthest of all points from the core: the radius reaches to it.";
    return "The last check, in exact arithmetic: " + where.name(fact.farthest) + " is farthest from the " +
           core(where) +
           (fact.widened ? ", and the radius grows in its last digit to contain it."
                         : ", and the " + (is_ball(where) ? where.ball() : "volume") + " contains it.");
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({{&fact.farthest, 1}}); }
  static std::string predicate(const Fact&, const FitWhere& where, bool) {
    return "is the farthest from the " + core(where);
  }

 private:
  static bool is_ball(const FitWhere& where) { return std::holds_alternative<fit::Sphere3>(where.step().volume); }
  static std::string core(const FitWhere& where) { return is_ball(where) ? "centre" : "core"; }
};

template <>
struct Entry<fit::SupportReplaced> : FitEntry {
  using Fact = fit::SupportReplaced;
  static constexpr std::array kQuestionKinds{kFarthest, kLeaves, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    std::vector<Index> gone;
    for (const Index i : fact.before)
      if (!fact.after.contains(i)) gone.push_back(i);
    const std::string left = gone.empty() ? "" : where.names(gone) + (gone.size() == 1 ? " leaves" : " leave");
    if (fact.entered == kNoIndex)
      return (left.empty() ? "The support set is solved again: its points" : left + " the support set: the others") +
             " support the " + where.ball() + " alone.";
    return where.name(fact.entered) + " joins the support set" +
           (left.empty() ? ", and none leaves it." : ", and " + left + " it.");
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({{&fact.entered, 1}}); }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "enters the support set"; }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere&) { return Mark::Kind::kReplaced; }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return fact.after.list(); }
};

template <>
struct Entry<fit::CandidateTried<double, 3>> : FitEntry {
  using Fact = fit::CandidateTried<double, 3>;
  using Verdict = Fact::Verdict;
  static constexpr std::array kQuestionKinds{kBetter, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string names = where.names(list_of(fact.points));
    // Through two points there are many circles, and through three many spheres.
    const bool one_of_many = fact.points.size() <= where.dim();
    const std::string tried = (one_of_many ? "The smallest " : "The ") + where.ball() + " through " + names;
    switch (fact.verdict) {
      case Verdict::kKept:
        return tried + " contains all points and, with radius " + number_text(fact.candidate.radius) +
               ", is the smallest so far: it is kept.";
      case Verdict::kNotSmaller: return tried + " is no smaller than the best: no point needs testing.";
      case Verdict::kLeavesPointOutside:
        return tried + " leaves " + where.name(fact.outside) + " outside, and is dropped.";
      case Verdict::kDependent:
        return names + " lie " + (fact.points.size() <= 3 ? "on one line" : "in one plane") +
               ", so they determine no " + where.ball() + ".";
      case Verdict::kNoBall: break;
    }
    return "The smallest " + where.ball() + " around " + names +
           " is supported by fewer of them: it is not a new candidate.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return fact.outside != kNoIndex ? std::vector{fact.outside} : list_of(fact.points);
  }
  static std::string predicate(const Fact& fact, const FitWhere&, bool plural) {
    return fact.outside != kNoIndex ? "lies outside" : plural ? "are tried" : "is tried";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) {
    return best_if(fact.verdict == Verdict::kKept, where);
  }
  static std::optional<std::vector<Index>> support(const Fact& fact) {
    return fact.verdict == Verdict::kKept ? std::optional(fact.points.list()) : std::nullopt;
  }
};

template <>
struct Entry<fit::Finished> : FitEntry {
  using Fact = fit::Finished;
  static constexpr std::array kQuestionKinds{kHolds, kSlab, kGrows, kOutside, kFirstWrong};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    // The iterative algorithm starts from Ritter's result: the same fact, but not the end.
    if (where.next() != nullptr)
      return "It starts from Ritter's " + where.ball() + ", with radius " + number_text(where.radius()) + ".";
    const std::string done = "Done: " + where.size(), names = where.names(fact.support);
    if (std::holds_alternative<ConvexHull<double, 3>>(where.step().volume) && where.run.axes_by_hand().empty())
      return done + "; the hull has " +
             (fact.support.size() == 1 ? "1 vertex."
                                       : count_text(static_cast<std::int64_t>(fact.support.size())) + " vertices.");
    // A naive algorithm's rounded sphere may miss the points that it names.
    if (where.run.wrong() != nullptr && std::holds_alternative<fit::Sphere3>(where.step().volume))
      return done + ", computed from " + names + ".";
    return where.run.exact() ? done + ", supported by " + names + "." : done + "; it touches " + names + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.support}); }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return fact.support; }
};

}  // namespace snug::lesson
