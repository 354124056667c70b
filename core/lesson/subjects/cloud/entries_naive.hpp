// The entries of the facts that only textbook algorithms report.
#pragma once

#include "lesson/subjects/cloud/entries_sphere.hpp"

namespace snug::lesson {

template <>
struct Entry<fit::CircumsphereFailed> : FitEntry {
  using Fact = fit::CircumsphereFailed;
  static std::string sentence(const Fact& fact, const FitWhere& where) {
    return "The formula for the " + std::string(where.ball()) + " through " + where.names(list_of(fact.points)) +
           " divides by a number that rounds to 0: " + where.name(last(fact)) + " is passed over.";
  }
  static std::vector<Index> handles(const Fact& fact, const FitWhere&) { return {last(fact)}; }
  static std::string predicate(const Fact&, const FitWhere&, bool) { return "is passed over"; }
  static std::optional<Mark::Kind> mark(const Fact&, const FitWhere&) { return Mark::Kind::kReplaced; }

 private:
  static Index last(const Fact& fact) { return fact.points[fact.points.size() - 1]; }
};

template <>
struct Entry<fit::TestsExhausted> : FitEntry {
  static std::string sentence(const fit::TestsExhausted& fact, const FitWhere& where) {
    return "Stopped after " + counted(fact.tests, "test") + ", the most that are allowed: the " + where.ball() +
           " is left as it is.";
  }
  static std::optional<Mark::Kind> mark(const auto&, const FitWhere&) { return Mark::Kind::kReplaced; }
};

}  // namespace snug::lesson
