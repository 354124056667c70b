#include "measure/sample.hpp"

#include <utility>

#include "fit/catalogue.hpp"
#include "geometry/random.hpp"

namespace snug::cost {
namespace {

/// The index of one point in part i of n equal parts of a set. size: that of the set.
Index place_in(Index i, Index n, Index size, Random& random) {
  const auto begin = static_cast<Index>(std::int64_t{i} * size / n);
  const auto end = static_cast<Index>((std::int64_t{i} + 1) * size / n);
  return begin + static_cast<Index>(random.below(static_cast<std::uint32_t>(end - begin)));
}

}  // namespace

AnyPointSet sample(const AnyPointSet& points, Index n, std::uint64_t seed) {
  return std::visit(
      [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) -> AnyPointSet {
        if (n >= set.size()) return set;
        Random random(seed);
        std::vector<Vector<Scalar, Dim>> chosen;
        chosen.reserve(n);
        for (Index i = 0; i < n; ++i) chosen.push_back(set[place_in(i, n, set.size(), random)]);
        return std::move(*PointSet<Scalar, Dim>::make(std::move(chosen)));  // finite, for the set was
      },
      points);
}

PointStream sample_stream(const AnyPointSet& points, Index n, std::uint64_t seed) {
  return [&points, n, size = fit::count_of(points), random = Random(seed), i = Index{0}]() mutable {
    return fit::point_of(points, place_in(i++, n, size, random));
  };
}

}  // namespace snug::cost
