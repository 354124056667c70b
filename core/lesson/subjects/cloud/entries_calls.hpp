// The entries of the facts of Welzl's recursion as lectures print it.
#pragma once

#include "lesson/subjects/cloud/entries_sphere.hpp"

namespace snug::lesson {

/// "returns": whether the call returns the sphere as it is, or makes the call on the other points again.
inline const char* offer_return(Asked& asked, const Run&) {
  asked.add_choice("It returns");
  asked.add_choice("It calls again");
  return nullptr;
}
inline Truth return_truth(const Asked& asked, const Run& run) {
  const auto& fact = *std::get_if<fit::CallDecided>(&fit_run(run).trace()[asked.fact].step.fact);
  const std::string point = asked.subject->name_of(fact.point);
  if (fact.outside) return {{1}, {fact.point}, "it calls again", point + " lies outside, so the call is made again."};
  return {{0}, {fact.point}, "it returns", point + " lies inside, so the call returns."};
}
inline constexpr QuestionKind kReturns{"returns", &offer_return, &return_truth};

template <>
struct Entry<fit::CallEntered> : FitEntry {
  using Fact = fit::CallEntered;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string boundary =
        fact.boundary.size() == 0 ? "" : ", with " + where.names(list_of(fact.boundary)) + " on the boundary";
    if (fact.point != kNoIndex)
      return "A call for " + counted(fact.left, "point") + boundary + ": it removes " + where.name(fact.point) +
             " and calls for the rest.";
    const std::string why = fact.left == 0 ? "No point is left" : "The support set is full";
    if (fact.boundary.size() == 0) return why + ": this call returns no " + where.ball() + " at all.";
    return why + ": this call returns the smallest " + where.ball() + " through " +
           where.names(list_of(fact.boundary)) + ", of radius " + number_text(where.radius()) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) {
    return fact.point != kNoIndex ? std::vector{fact.point} : list_of(fact.boundary);
  }
  static std::string predicate(const Fact& fact, const FitWhere& where, bool plural) {
    if (fact.point != kNoIndex) return "is removed";
    return (plural ? "are on the boundary of the " : "is on the boundary of the ") + where.ball();
  }
  static std::optional<std::vector<Index>> support(const Fact& fact) {
    return fact.point == kNoIndex ? std::optional(list_of(fact.boundary)) : std::nullopt;
  }
};

template <>
struct Entry<fit::CallDecided> : FitEntry {
  using Fact = fit::CallDecided;
  static constexpr std::array kQuestionKinds{kReturns};
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    const std::string point = where.name(fact.point);
    const std::string joins = ": it joins the support set, and the call for the rest is made again.";
    if (!where.step().has_volume) return point + " has no " + where.ball() + " to lie in" + joins;
    const double gap = fact.distance - where.radius();
    if (fact.outside) return point + " lies outside by " + number_text(gap) + joins;
    return point + " lies inside" + (gap < 0 ? " by " + number_text(-gap) : "") + ": this call returns the same " +
           where.ball() + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {fact.point}; }
  static std::string predicate(const Fact& fact, const FitWhere&, bool) {
    return fact.outside ? "lies outside" : "lies inside";
  }
  /// A mark where a point joins the support of the outermost calls.
  static std::optional<Mark::Kind> mark(const Fact& fact, const FitWhere& where) {
    return fact.outside && fact.boundary.size() == 0 ? std::optional(Mark::Kind::kReplaced) : first(where);
  }
};

template <>
struct Entry<fit::RecursionStopped> : FitEntry {
  using Fact = fit::RecursionStopped;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "The stack is full: " + counted(fact.depth, "call") + " are open, and " + counted(fact.left, "point") +
           (fact.left == 1 ? " is" : " are") + " still to be removed. The recursion is stopped, and farthest-point " +
           "pivoting finds the " + where.ball() + ".";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere&) { return Mark::Kind::kReplaced; }
};

}  // namespace snug::lesson
