#include "query/overlap/overlaps_spheres.hpp"

#include <algorithm>

#include "number/exact_sum.hpp"

namespace snug::query {

bool apart_exactly(const double* a, double radius_a, const double* b, double radius_b, int dim) noexcept {
  double square = 0;
  for (int i = 0; i < dim; ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  const double radii = radius_a + radius_b;
  const double larger = std::max(square, radii * radii);
  // The sum of the radii is rounded once, which adds 2u once it is squared.
  const double error_bound = (tolerance::kSquaredDistance<double> + 4 * tolerance::kRoundoff<double>)*larger;
  if (larger > 0x1p-900 && larger < 0x1p1000 && std::abs(square - radii * radii) > error_bound)
    return square > radii * radii;
  ExactSum sum;
  for (int i = 0; i < dim; ++i) {
    sum.add_product(a[i], a[i]);
    sum.add_product(-2 * a[i], b[i]);
    sum.add_product(b[i], b[i]);
  }
  sum.add_product(-radius_a, radius_a);
  sum.add_product(-2 * radius_a, radius_b);
  sum.add_product(-radius_b, radius_b);
  return sum.sign() > 0;
}

}  // namespace snug::query
