// Which points a trace speaks of.
#include <algorithm>
#include <array>

#include "lesson/ask.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

struct Named {
  std::vector<Index> points;

  void operator()(const ExtremesFound<double, 3>& fact) { add(fact.least), add(fact.greatest); }
  void operator()(const PairChosen& fact) { add(fact.a), add(fact.b); }
  void operator()(const FarthestFound& fact) { add(fact.point); }
  void operator()(const PointExamined& fact) { add(fact.point); }
  void operator()(const BallGrown<double, 3>& fact) { add(fact.point); }
  void operator()(const MovedToFront& fact) { add(fact.point); }
  void operator()(const SupportReplaced& fact) { add(fact.entered); }
  void operator()(const RadiusChecked& fact) { add(fact.farthest); }
  void operator()(const BoundaryForced& fact) { add(fact.boundary[fact.boundary.size() - 1]); }
  void operator()(const CandidateTried<double, 3>& fact) {
    if (fact.outside != kNoIndex) return add(fact.outside);
    for (const Index i : fact.points) add(i);
  }
  void operator()(const Finished& fact) {
    for (const Index i : fact.support) add(i);
  }
  void operator()(const auto&) {}

 private:
  void add(Index i) {
    if (i != kNoIndex && std::find(points.begin(), points.end(), i) == points.end()) points.push_back(i);
  }
  void add(const std::array<Index, 3>& indices) {
    for (const Index i : indices) add(i);
  }
};

/// The support as a step states it; nothing where the step leaves it as it was.
struct Stated {
  std::optional<Support> operator()(const PairChosen& fact) const { return Support{fact.a, fact.b}; }
  std::optional<Support> operator()(const FarthestFound& fact) const { return Support{fact.point}; }
  std::optional<Support> operator()(const BallGrown<double, 3>& fact) const { return Support{fact.point}; }
  std::optional<Support> operator()(const BallShrunk<double, 3>&) const { return Support{}; }
  std::optional<Support> operator()(const BoundaryForced& fact) const { return fact.boundary; }
  std::optional<Support> operator()(const SupportReplaced& fact) const { return fact.after; }
  std::optional<Support> operator()(const Finished& fact) const { return fact.support; }
  std::optional<Support> operator()(const CandidateTried<double, 3>& fact) const {
    if (fact.verdict != CandidateTried<double, 3>::Verdict::kKept) return std::nullopt;
    return fact.points;
  }
  std::optional<Support> operator()(const auto&) const { return std::nullopt; }
};

}  // namespace

std::string point_name(Index i) { return "P" + std::to_string(i); }

std::vector<Index> points_named(const Step3& step) {
  Named named;
  std::visit(named, step.fact);
  return std::move(named.points);
}

Support support_after(Trace trace, int steps) {
  for (int i = steps; i-- > 0;)
    if (const auto support = std::visit(Stated{}, trace[static_cast<std::size_t>(i)].step.fact)) return *support;
  return {};
}

}  // namespace snug::lesson
