// Which points a trace speaks of.
#include <algorithm>
#include <array>

#include "lesson/ask.hpp"
#include "lesson/boxes.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

struct Named {
  int dim;
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
  void operator()(const Finished& fact) { add(fact.support); }
  void operator()(const ExtentsFound<double, 3>& fact) { add(fact.least), add(fact.greatest); }
  void operator()(const BallFound<double, 3>& fact) { add(fact.support); }
  void operator()(const HullFound& fact) { add(fact.vertices); }
  void operator()(const PointsChosen& fact) { add(fact.points); }
  void operator()(const RectangleFound<double, 3>& fact) { add(fact.edge_a), add(fact.edge_b); }
  void operator()(const EdgeSearched& fact) { add(fact.a), add(fact.b); }
  void operator()(const query::CornerTried& fact) { add(index_of(dim, {Place::Kind::kCorner, fact.box, fact.corner})); }
  void operator()(const query::AxisTested<double, 3>& fact) {
    for (int bits = 0; bits < 8; ++bits)
      if ((fact.near_b >> bits & 1) != 0) add(index_of(dim, {Place::Kind::kCorner, 1, bits}));
  }
  void operator()(const query::CornerTested<double, 3>& fact) {
    add(index_of(dim, {Place::Kind::kCorner, 0, fact.corner}));
  }
  void operator()(const query::PlaneTested<double, 3>& fact) {
    for (const int corner : {fact.p_vertex, fact.n_vertex})
      if (!fact.skipped) add(index_of(dim, {Place::Kind::kCorner, 0, corner}));
  }
  void operator()(const BoxWidened& fact) { add(fact.point); }
  void operator()(const LineFound& fact) { add(fact.support); }
  void operator()(const EndPulledIn& fact) { add(fact.point); }
  void operator()(const ThicknessFound& fact) { add(fact.least), add(fact.greatest); }
  void operator()(const SidePulledIn& fact) { add(fact.point); }
  void operator()(const CornerMovedOut& fact) { add(fact.point); }
  void operator()(const SlabFound& fact) { add(fact.least), add(fact.greatest); }
  void operator()(const SimplexChosen& fact) { add(fact.points); }
  void operator()(const FlatFound& fact) { add(fact.points); }
  void operator()(const EyeChosen& fact) { add(fact.point); }
  void operator()(const EdgeSplit& fact) { add(fact.point); }
  void operator()(const HorizonFound& fact) { add(fact.horizon); }
  void operator()(const auto&) {}

 private:
  void add(Index i) {
    if (i != kNoIndex && std::find(points.begin(), points.end(), i) == points.end()) points.push_back(i);
  }
  void add(const auto& indices) {
    for (const Index i : indices) add(i);
  }
};

using Points = std::optional<std::vector<Index>>;

/// The support as a step states it; nothing where the step leaves it as it was.
struct Stated {
  Points operator()(const PairChosen& fact) const { return {{fact.a, fact.b}}; }
  Points operator()(const FarthestFound& fact) const { return {{fact.point}}; }
  Points operator()(const BallGrown<double, 3>& fact) const { return {{fact.point}}; }
  Points operator()(const BallShrunk<double, 3>&) const { return {std::vector<Index>{}}; }
  Points operator()(const BoundaryForced& fact) const { return fact.boundary.list(); }
  Points operator()(const SupportReplaced& fact) const { return fact.after.list(); }
  Points operator()(const Finished& fact) const { return fact.support; }
  Points operator()(const ExtentsFound<double, 3>& fact) const {
    Named named{3, {}};
    named(fact);
    return std::move(named.points);
  }
  Points operator()(const CandidateTried<double, 3>& fact) const {
    if (fact.verdict != CandidateTried<double, 3>::Verdict::kKept) return std::nullopt;
    return fact.points.list();
  }
  Points operator()(const auto&) const { return std::nullopt; }
};

}  // namespace

std::string point_name(Index i) { return "P" + std::to_string(i); }

std::vector<Index> points_named(const Step3& step, int dim) {
  Named named{dim, {}};
  std::visit(named, step.fact);
  return std::move(named.points);
}

std::vector<Index> support_after(Trace trace, int steps) {
  for (int i = steps; i-- > 0;)
    if (auto support = std::visit(Stated{}, trace[i].step.fact)) return *std::move(support);
  return {};
}

}  // namespace snug::lesson
