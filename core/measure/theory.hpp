// What is proven or known of each algorithm's time, to stand beside what is measured.
#pragma once

#include <string_view>

namespace snug::cost {

struct Theory {
  std::string_view volume, algorithm;
  std::string_view bound;    // "O(n log n)"; of n points, h of them on the hull
  double (*work)(double n);  // up to a factor, where as many are on the hull as can be; for its slope
  bool tight;                // whether times grow so on any points; false: an upper bound
  std::string_view source;
  std::string_view plane_bound = {};  // in 2-D, where that is another
  double (*plane_work)(double n) = nullptr;
};

/// Null where nothing is known.
[[nodiscard]] const Theory* find_theory(std::string_view volume, std::string_view algorithm);

[[nodiscard]] inline std::string_view bound_of(const Theory& theory, int dim) {
  return dim == 2 && !theory.plane_bound.empty() ? theory.plane_bound : theory.bound;
}
[[nodiscard]] inline auto work_of(const Theory& theory, int dim) {
  return dim == 2 && theory.plane_work != nullptr ? theory.plane_work : theory.work;
}

}  // namespace snug::cost
