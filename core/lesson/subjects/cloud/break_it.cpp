#include "lesson/subjects/cloud/break_it.hpp"

#include "fit/catalogue.hpp"

namespace snug::lesson {

ScalarsCompared compare_scalars(std::string_view goal, const AnyPointSet& points, std::uint64_t seed) {
  const bool hull = goal == kCloudGoals[1];
  const fit::Algorithm& naive =
      *(hull ? fit::find_algorithm("hull", "quickhull_rounded") : fit::find_algorithm("sphere", "welzl_naive"));
  const int dim = fit::dim_of(points);
  ScalarsCompared compared;
  const auto rounded = to_set(all_points(points), dim, true);
  compared.fits = rounded && fit::count_of(points) <= naive.max_points && fit::takes(naive, dim);
  if (!compared.fits) return compared;
  const auto judged = [&](const AnyPointSet& set) {
    const fit::Result result = naive.fit(set, {.seed = seed});
    compared.of = of_ulps(result);
    return *left_by(set, result);
  };
  compared.in_float = judged(*rounded);
  compared.in_double = judged(*to_set(all_points(*rounded), dim));
  return compared;
}

bool breaks(const ScalarsCompared& compared) { return !compared.in_float.none() && compared.in_double.none(); }

std::string says_of(const ScalarsCompared& compared, const std::function<std::string(Index)>& name_of) {
  if (!compared.fits) return "The algorithm cannot take these points in float.";
  const auto says = [&](const LeftOutside& left) {
    if (!left.dents.empty() && left.points.empty()) return "the hull has a dent at " + name_of(left.dents.front());
    if (left.points.empty()) return std::string("no point is outside");
    return name_of(left.worst) + " is outside by " + worst_text(left, compared.of);
  };
  return "In float, " + says(compared.in_float) + "; in double, " + says(compared.in_double) + ".";
}

}  // namespace snug::lesson
