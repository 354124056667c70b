#include "measure/sample.hpp"

#include <utility>

#include "geometry/random.hpp"

namespace snug::cost {

AnyPointSet sample(const AnyPointSet& points, Index n, std::uint64_t seed) {
  return std::visit(
      [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) -> AnyPointSet {
        if (n >= set.size()) return set;
        Random random(seed);
        std::vector<Vector<Scalar, Dim>> chosen;
        chosen.reserve(static_cast<std::size_t>(n));
        for (Index i = 0; i < n; ++i) {
          const auto begin = static_cast<Index>(std::int64_t{i} * set.size() / n);
          const auto end = static_cast<Index>((std::int64_t{i} + 1) * set.size() / n);
          chosen.push_back(set[begin + static_cast<Index>(random.below(static_cast<std::uint32_t>(end - begin)))]);
        }
        return std::move(*PointSet<Scalar, Dim>::make(std::move(chosen)));  // finite, for the set was
      },
      points);
}

}  // namespace snug::cost
