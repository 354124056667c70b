// The entries of the facts that fitters of boxes, sphere-swept volumes and k-DOPs report.
#pragma once

#include "lesson/subjects/cloud/calipers_decisions.hpp"
#include "lesson/subjects/cloud/edge_pairs.hpp"
#include "lesson/subjects/cloud/entries_sphere.hpp"

namespace snug::lesson {

template <>
struct Entry<fit::ExtentsFound<double, 3>> : FitEntry {
  using Fact = fit::ExtentsFound<double, 3>;
  static constexpr std::array kQuestionKinds{kSmallestEdge, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    std::string lengths;
    for (int i = 0; i < where.dim(); ++i) lengths += (i > 0 ? " × " : "") + number_text(fact.lengths[i]);
    return "The points that reach farthest along each axis set the box's extents: " + lengths + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return points_of({fact.least, fact.greatest});
  }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "reach farthest along the box's axes"; }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return points_of({fact.least, fact.greatest}); }
};

template <>
struct Entry<fit::BallFound<double, 3>> : FitEntry {
  using Fact = fit::BallFound<double, 3>;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "The smallest " + where.ball() + " around the points has radius " + number_text(fact.ball.radius) +
           "; it is supported by " + where.names(list_of(fact.support)) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return list_of(fact.support); }
};

template <>
struct Entry<fit::HullFound> : FitEntry {
  using Fact = fit::HullFound;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "The convex hull has " +
           (fact.vertices.size() == 1 ? "1 vertex"
                                      : count_text(static_cast<std::int64_t>(fact.vertices.size())) + " vertices") +
           " and " + counted(fact.facets, where.dim() == 2 ? "edge" : "face") + ": no point inside it can touch a box.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.vertices}); }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "are the vertices of the hull"; }
};

template <>
struct Entry<fit::SurfaceFound<double, 3>> : FitEntry {
  static std::string sentence(const fit::SurfaceFound<double, 3>& fact, const FitWhere& where) {
    return "The hull's " + where.outline_word() + " measures " + number_text(fact.area) +
           (where.dim() == 2 ? " units: every piece of it counts by its length,"
                             : " units²: every piece of it counts by its area,") +
           " however many points lie on it.";
  }
};

/// "sign": whether a point's products raise or lower the sum of x y.
const char* offer_signs(Asked& asked, const Run& run);
Truth sign_truth(const Asked& asked, const Run& run);

template <>
struct Entry<fit::ProductsAdded<double, 3>> : FitEntry {
  using Fact = fit::ProductsAdded<double, 3>;
  static constexpr std::array kQuestionKinds{
      QuestionKind{
          .name = "sign", .offer = &offer_signs, .truth = &sign_truth, .margin = &sign_margin, .rules = kSignRules},
      kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    std::string offset;
    for (int i = 0; i < where.dim(); ++i) offset += (i > 0 ? ", " : "") + coordinate_text(fact.offset[i]);
    const std::string name = where.name(fact.point);
    return name + (fact.from_mean ? " lies (" + offset + ") from the mean" : " is (" + offset + ")") +
           ": the products of these coordinates are added to the sums.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "is added to the sums"; }
};

template <>
struct Entry<fit::PointsChosen> : FitEntry {
  using Fact = fit::PointsChosen;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const bool one = fact.points.size() == 1;
    return where.names(list_of(fact.points)) + (one ? " is" : " are") + " chosen: the axes are built on " +
           (one ? "it." : "them.");
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.points}); }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "are chosen" : "is chosen";
  }
};

template <>
struct Entry<fit::BoxTried<double, 3>> : FitEntry {
  using Fact = fit::BoxTried<double, 3>;
  static constexpr std::array kQuestionKinds{kTouched, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "The box " + axes_of(fact, where) + " has " + where.size_word() + number_text(fact.measure) +
           (fact.better ? ", the smallest so far: it is kept." : ", no smaller than the best: it is dropped.");
  }
  /// What its axes follow from. Of points that follow an edge in the plane, the box only touches the others.
  static std::string axes_of(const Fact& fact, const FitWhere& where) {
    const auto edge = [&](std::size_t i) {
      return "from " + where.name(fact.on[i]) + " to " + where.name(fact.on[i + 1]);
    };
    const bool dito = std::holds_alternative<fit::PointsChosen>(where.run.trace().front().step.fact);
    if (fact.on.empty()) return "from PCA";
    if (fact.on.size() == 1) return "on " + where.name(fact.on[0]);
    if (where.dim() == 2 || fact.on.size() == 2) return "on the edge " + edge(0);
    if (dito) return "along the edge " + edge(0) + ", with a face through " + where.name(fact.on[2]) + ",";
    if (fact.on.size() == 4 && searches_edges(where)) return "on the edges " + edge(0) + " and " + edge(2);
    return "on the face of " + where.names(list_of(fact.on));
  }
  /// Whether the search goes through pairs of edges.
  static bool searches_edges(const FitWhere& where) {
    const auto rest = where.run.trace().subspan(static_cast<std::size_t>(where.i));
    return std::any_of(rest.begin(), rest.end(),
                       [](const auto& one) { return std::holds_alternative<fit::EdgeSearched>(one.step.fact); });
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) { return best_if(fact.better, where); }
};

template <>
struct Entry<fit::RotationTried<double, 3>> : FitEntry {
  using Fact = fit::RotationTried<double, 3>;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string measure = where.size_word() + number_text(fact.measure);
    if (fact.number == 0) return "Along the world's axes, the box has " + measure + ".";
    const std::string passed =
        fact.passed == 0 ? "" : " after " + counted(fact.passed, "rotation") + " that brought no smaller one";
    return "Rotation " + count_text(fact.number) + " of " + count_text(fact.of) + " has the smallest box so far" +
           passed + ": " + measure + '.';
  }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere& where) { return best_if(true, where); }
};

template <>
struct Entry<fit::RectangleFound<double, 3>> : FitEntry {
  using Fact = fit::RectangleFound<double, 3>;
  static constexpr std::array kQuestionKinds{kHullEdge, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string on = fact.edge_a == kNoIndex ? "The smallest rectangle"
                                                   : "The smallest rectangle lies on the hull's edge from " +
                                                         where.name(fact.edge_a) + " to " + where.name(fact.edge_b);
    return on + (where.dim() == 2 ? ": " : ", in the projection along the axis; its box has ") + where.size_word() +
           number_text(fact.measure) + (fact.better ? gain(fact, where) : ": no better than before.");
  }
  /// How much smaller it is than the box before.
  static std::string gain(const Fact& fact, const FitWhere& where) {
    const bool first = where.before() == nullptr || !where.before()->has_volume;
    const double before = first ? 0 : fit::measure_of(where.before()->volume, where.dim());
    if (!(before > fact.measure)) return ", the smallest so far.";
    const std::string gain = without_plus(percent_text(1 - fact.measure / before));
    return ", " + (gain == "0.0 %" ? "less by under 0.1 %" : gain + " less than before") + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return points_of({{&fact.edge_a, 1}, {&fact.edge_b, 1}});
  }
  static std::string predicate(const Fact&, const FitWhere&, bool) {
    return "are the ends of the edge that the rectangle lies on";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) { return best_if(fact.better, where); }
};

template <>
struct Entry<fit::CalipersTurned<double, 3>> : FitEntry {
  using Fact = fit::CalipersTurned<double, 3>;
  static constexpr std::array kQuestionKinds{kSmaller, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string area = " has area " + number_text(fact.area);
    return "On the projection's edge from " + where.name(fact.touching[0]) + " to " + where.name(fact.touching[1]) +
           ", the rectangle" + area +
           (fact.better ? ", the smallest so far." : "; the smallest so far has " + number_text(fact.least) + ".");
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return {fact.touching.begin(), fact.touching.begin() + 2};
  }
  static std::string predicate(const Fact&, const FitWhere&, bool) {
    return "are the ends of the edge on which the calipers stand";
  }
};

template <>
struct Entry<fit::EdgeSearched> : FitEntry {
  using Fact = fit::EdgeSearched;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const EdgePairs pairs = edge_pairs(where.run.trace(), where.i + 1);
    const std::string edge = "The edge from " + where.name(fact.a) + " to " + where.name(fact.b) + " with ";
    const std::string best =
        "Best so far: " + where.size_word() + number_text(fit::measure_of(where.step().volume, where.dim()));
    return edge + outcome(fact) + best + "; " + left_words(pairs);
  }
  /// What became of its pairs.
  static std::string outcome(const Fact& fact) {
    if (fact.pairs == 0) return "no other makes a box. ";
    const std::string others = fact.pairs == 1 ? "one other: " : "each of " + count_text(fact.pairs) + " others: ";
    const Index searched = fact.pairs - fact.ruled_out;
    if (searched == 0) return others + (fact.pairs == 1 ? "ruled out at once. " : "all are ruled out at once. ");
    const std::string after =
        fact.halvings == 0 ? " without halving. " : " after " + counted(fact.halvings, "halving") + ". ";
    if (fact.ruled_out == 0) return others + "done" + after;
    return others + count_text(fact.ruled_out) + (fact.ruled_out == 1 ? " is" : " are") +
           " ruled out at once, the rest" + after;
  }
  static std::string left_words(const EdgePairs& pairs) {
    if (pairs.left == 0) return "no pair is left.";
    return count_text(pairs.left) + " of " + count_text(pairs.all) + " pairs left.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.a, fact.b}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "are the ends of the edge"; }
};

template <>
struct Entry<fit::BoxWidened> : FitEntry {
  using Fact = fit::BoxWidened;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return where.name(fact.point) + " lies outside the box so far: the box is widened to it.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "widens the box"; }
};

template <>
struct Entry<fit::LineFound> : FitEntry {
  using Fact = fit::LineFound;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "Of all lines along the main axis, this one comes closest to all points: " + where.names(fact.support) +
           (fact.support.size() == 1 ? " is" : " are") + " farthest from it, at " + number_text(fact.radius) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.support}); }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "are farthest from the line" : "is farthest from the line";
  }
};

template <>
struct Entry<fit::EndPulledIn> : FitEntry {
  using Fact = fit::EndPulledIn;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return std::string(fact.end == 0 ? "The first" : "The second") + " end is pulled in by " + number_text(fact.by) +
           ", until its cap touches " + where.name(fact.point) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "touches the cap"; }
};

template <>
struct Entry<fit::ThicknessFound> : FitEntry {
  using Fact = fit::ThicknessFound;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string radius = number_text(fact.radius);
    if (where.dim() == 2)
      return "The radius is " + radius + ", the largest for which no rounded vertex cuts off a point.";
    return "The radius is half of the points' least extent along these axes: " + radius + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return points_of({{&fact.least, 1}, {&fact.greatest, 1}});
  }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "set the radius" : "sets the radius";
  }
};

template <>
struct Entry<fit::SidePulledIn> : FitEntry {
  using Fact = fit::SidePulledIn;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "Side " + std::to_string(fact.side + 1) + " of the rectangle is pulled in by " + number_text(fact.by) +
           ", until it touches " + where.name(fact.point) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "touches the side"; }
};

template <>
struct Entry<fit::CornerMovedOut> : FitEntry {
  using Fact = fit::CornerMovedOut;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return where.name(fact.point) +
           " lies outside, beyond a vertex of the rectangle: the vertex moves out until the volume contains it.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "lies outside, beyond a vertex"; }
};

template <>
struct Entry<fit::SlabFound> : FitEntry {
  using Fact = fit::SlabFound;
  static constexpr std::array kQuestionKinds{kExtremes, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "Slab " + std::to_string(fact.slab + 1) + " lies between " + where.name(fact.least) + " and " +
           where.name(fact.greatest) + ", the extremes along " + where.run.slab_name(where.i, fact.slab) + ".";
  }
  /// They stay on its boundary, however it is cut further.
  static std::vector<Index> adds_to_support(const Fact& fact) {
    return points_of({{&fact.least, 1}, {&fact.greatest, 1}});
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return points_of({{&fact.least, 1}, {&fact.greatest, 1}});
  }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "reach farthest along the axis" : "reaches farthest along the axis";
  }
};

}  // namespace snug::lesson
