// What is proven or known about an algorithm's time, to compare with the measured time.
#pragma once

#include <cmath>
#include <string_view>

namespace snug::fit {

struct Theory {
  std::string_view bound;              // "O(n log n)"; n points, h of them on the hull
  double (*work)(double n) = nullptr;  // up to a factor, with all points on the hull; for its slope
  bool tight = false;                  // whether the time grows like this on all points; false: it is an upper bound
  std::string_view source;
  std::string_view plane_bound = {};  // in 2-D, if that differs
  double (*plane_work)(double n) = nullptr;
};

[[nodiscard]] inline std::string_view bound_of(const Theory& theory, int dim) {
  return dim == 2 && !theory.plane_bound.empty() ? theory.plane_bound : theory.bound;
}
[[nodiscard]] inline auto work_of(const Theory& theory, int dim) {
  return dim == 2 && theory.plane_work != nullptr ? theory.plane_work : theory.work;
}

namespace growth {
inline double linear(double n) { return n; }
inline double sorting(double n) { return n * std::log(n); }
inline double square(double n) { return n * n; }
inline double fourth(double n) { return n * n * n * n; }
inline double fifth(double n) { return fourth(n) * n; }
}  // namespace growth

// Theory that several algorithms share.

inline constexpr Theory kFixedPasses{"O(n)", growth::linear, true,
                                     "a fixed number of passes over the points, as the code shows"};
inline constexpr Theory kFewPasses{
    "O(n) a pass, few passes", growth::linear, false,
    "no bound on the passes is proven; B. Gärtner, Fast and robust smallest enclosing balls, 1999"};
inline constexpr Theory kBalancedHull{
    "O(n log n) if balanced", growth::sorting, false,
    "C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, 1996"};

}  // namespace snug::fit
