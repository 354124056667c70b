// The entries of the facts that Quickhull reports.
#pragma once

#include "lesson/subjects/cloud/entries_sphere.hpp"

namespace snug::lesson {

template <>
struct Entry<fit::SimplexChosen> : FitEntry {
  using Fact = fit::SimplexChosen;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return std::string("The first hull is the ") + (where.dim() == 2 ? "segment" : "tetrahedron") + " of " +
           where.names(fact.points) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.points}); }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "are the vertices of the first hull"; }
  static std::optional<std::vector<Index>> support(const Fact& fact) { return fact.points; }
};

template <>
struct Entry<fit::FlatFound> : FitEntry {
  using Fact = fit::FlatFound;
  static std::string sentence(const Fact& fact, const FitWhere&) {
    constexpr std::array<const char*, 3> kWhere{"in one place", "on one line", "in one plane"};
    return std::string("All points lie ") + kWhere[fact.affine_dim] + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.points}); }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "span all points" : "is where all points are";
  }
};

template <>
struct Entry<fit::PointsAssigned> : FitEntry {
  using Fact = fit::PointsAssigned;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return said(fact, where) + where.contradiction();
  }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere& where) {
    return where.is_first_wrong() ? std::optional(Mark::Kind::kWrong) : first(where);
  }
  static std::string said(const Fact& fact, const FitWhere& where) {
    std::int64_t outside = 0;
    for (const Index count : fact.counts) outside += count;
    const std::string facet = where.dim() == 2 ? "edge" : "facet";
    if (outside == 0 && fact.dropped == 0) return "No point is left to assign to these " + facet + "s.";
    const std::string are_dropped = fact.dropped == 1 ? " is dropped." : " are dropped.";
    if (outside == 0)
      return "No point lies outside these " + facet + "s: " + counted(fact.dropped, "point") + are_dropped;
    const std::string assigned =
        counted(outside, "point") + (outside == 1
                                         ? " lies outside and is assigned to the " + facet + " that it is outside of"
                                         : " lie outside and are assigned to " + facet + "s");
    if (fact.dropped == 0) return assigned + "; none is dropped.";
    // Inside, or exactly on the outline.
    return assigned + "; " + count_text(fact.dropped) + (fact.dropped == 1 ? " does not, and" : " do not, and") +
           are_dropped;
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.inside}); }
  static std::string predicate(const Fact&, const FitWhere&, bool plural) {
    return plural ? "are dropped" : "is dropped";
  }
};

template <>
struct Entry<fit::EyeChosen> : FitEntry {
  using Fact = fit::EyeChosen;
  static constexpr std::array kQuestionKinds{kEye, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return where.name(fact.point) + " is farthest from its " + (where.dim() == 2 ? "edge" : "facet") + ", at " +
           number_text(fact.distance) + ": it becomes a vertex.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere& where, bool) {
    return std::string("is farthest from the ") + (where.dim() == 2 ? "edge" : "facet");
  }
};

template <>
struct Entry<fit::EdgeSplit> : FitEntry {
  using Fact = fit::EdgeSplit;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "The edge from " + where.name(fact.a) + " to " + where.name(fact.b) + " is replaced by two, which meet at " +
           where.name(fact.point) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "splits the edge"; }
  static std::vector<Index> adds_to_support(const Fact& fact) { return {fact.point}; }
};

template <>
struct Entry<fit::HorizonFound> : FitEntry {
  using Fact = fit::HorizonFound;
  static constexpr std::array kQuestionKinds{kFaces, kGrows};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return where.name(fact.eye) + " sees " + counted(static_cast<std::int64_t>(fact.facets.size()), "facet") +
           (fact.facets.size() == 1 ? "; its" : "; their") + " boundary is the horizon.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return points_of({fact.horizon}); }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "are on the horizon"; }
};

template <>
struct Entry<fit::FacetsReplaced> : FitEntry {
  using Fact = fit::FacetsReplaced;
  static std::vector<Index> adds_to_support(const Fact& fact) { return {fact.eye}; }
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return counted(static_cast<std::int64_t>(fact.removed.size()), "facet") +
           (fact.removed.size() == 1 ? " is" : " are") + " replaced by " + std::to_string(fact.added.size()) +
           " new ones, from the horizon to " + where.name(fact.eye) + ".";
  }
};

template <>
struct Entry<fit::FacesMerged> : FitEntry {
  static std::string sentence(const fit::FacesMerged& fact, const FitWhere&) {
    const std::string faces = "Coplanar facets are merged into " + counted(fact.faces, "face");
    if (fact.dropped.empty()) return faces + ".";
    return faces + ", and " + counted(static_cast<std::int64_t>(fact.dropped.size()), "point") +
           (fact.dropped.size() == 1 ? " that lies on a face is not a vertex."
                                     : " that lie on faces are not vertices.");
  }
};

}  // namespace snug::lesson
