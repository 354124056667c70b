#include "lesson/subjects/cloud/break_it.hpp"

#include "fit/catalogue.hpp"

namespace snug::lesson {

ScalarsCompared compare_scalars(const AnyPointSet& points, std::uint64_t seed) {
  const fit::Algorithm& naive = *fit::find_algorithm("sphere", "welzl_naive");
  const int dim = fit::dim_of(points);
  ScalarsCompared compared;
  const auto rounded = to_set(all_points(points), dim, true);
  compared.fits = rounded && fit::size_of(points) <= naive.max_points;
  if (!compared.fits) return compared;
  const auto judged = [&](const AnyPointSet& set) {
    return left_outside(set, ball_of(naive.fit(set, {.seed = seed})));
  };
  compared.in_float = judged(*rounded);
  compared.in_double = judged(*to_set(all_points(*rounded), dim));
  return compared;
}

bool breaks(const ScalarsCompared& compared) {
  return !compared.in_float.points.empty() && compared.in_double.points.empty();
}

std::string says_of(const ScalarsCompared& compared, const std::function<std::string(Index)>& name_of) {
  if (!compared.fits) return "These points are too large for float, or too many.";
  const auto says = [&](const LeftOutside& left) {
    if (left.points.empty()) return std::string("no point is outside");
    return name_of(left.worst) + " is outside by " + ulps_text(left.ulps()) + " of the radius";
  };
  return "In float, " + says(compared.in_float) + "; in double, " + says(compared.in_double) + ".";
}

}  // namespace snug::lesson
