#include <algorithm>

#include "fit/merge/merge.hpp"

namespace snug::fit {

template <class Scalar, int Dim>
Kdop<Scalar, Dim> merge(const Kdop<Scalar, Dim>& a, const Kdop<Scalar, Dim>& b) {
  const auto axes_a = kdop_axes<Dim>(a.k), axes_b = kdop_axes<Dim>(b.k);
  Kdop<Scalar, Dim> merged;
  std::size_t slabs = 0, j = 0;
  // Axes that are in both lists are in the same order there.
  for (std::size_t i = 0; i < axes_a.size(); ++i) {
    const auto found = std::find(axes_b.begin() + static_cast<std::ptrdiff_t>(j), axes_b.end(), axes_a[i]);
    if (found == axes_b.end()) continue;
    j = static_cast<std::size_t>(found - axes_b.begin());
    merged.min[slabs] = std::min(a.min[i], b.min[j]);
    merged.max[slabs] = std::max(a.max[i], b.max[j]);
    ++slabs;
  }
  merged.k = 2 * static_cast<int>(slabs);
  return merged;
}

template Kdop<float, 2> merge(const Kdop<float, 2>&, const Kdop<float, 2>&);
template Kdop<float, 3> merge(const Kdop<float, 3>&, const Kdop<float, 3>&);
template Kdop<double, 2> merge(const Kdop<double, 2>&, const Kdop<double, 2>&);
template Kdop<double, 3> merge(const Kdop<double, 3>&, const Kdop<double, 3>&);

}  // namespace snug::fit
