#include "lesson/subjects/criteria/shape_costs.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostShapes = 4;

bool same(const AnyPointSet& a, const AnyPointSet& b) {
  const Index n = fit::count_of(a);
  if (a.index() != b.index() || n != fit::count_of(b)) return false;
  for (Index i = 0; i < n; ++i)
    if (fit::point_of(a, i) != fit::point_of(b, i)) return false;
  return true;
}

bool takes(const Method& method, const AnyPointSet& points) {
  return fit::count_of(points) <= method.max_points && (fit::dim_of(points) == 2 ? method.plane : method.space);
}

const fit::Algorithm& catalogued(const Method& method) { return *fit::find_algorithm(method.volume, method.name); }

std::shared_ptr<ShapeCosts> fitted(const AnyPointSet& points, const std::vector<const Method*>& methods,
                                   std::uint64_t seed) {
  auto shape = std::make_shared<ShapeCosts>(ShapeCosts{points, {}, {}});
  const fit::Options options{.seed = seed};
  const cost::Rounding rounding = cost::rounding_of(points);
  const int dim = fit::dim_of(points);
  const double hull = fit::measure_of(fit::find_algorithm("hull", "quickhull")->fit(points, options).volume, dim);
  for (const Method* method : methods) {
    if (!takes(*method, points)) continue;
    fit::Volume3 volume = catalogued(*method).fit(points, options).volume;
    const auto over_hull = rounding.ratio(fit::measure_of(volume, dim), hull, dim);
    shape->volumes.push_back({method, std::move(volume), over_hull});
  }
  return shape;
}

}  // namespace

std::shared_ptr<ShapeCosts> ShapeStore::shape(const AnyPointSet& points, const std::vector<const Method*>& methods,
                                              std::uint64_t seed) {
  const auto found =
      std::find_if(shapes_.rbegin(), shapes_.rend(), [&](const auto& known) { return same(known->points, points); });
  if (found != shapes_.rend()) return *found;
  if (shapes_.size() == kMostShapes) {  // rather one that was not measured
    const auto idle =
        std::find_if(shapes_.begin(), shapes_.end(), [](const auto& known) { return known->rows.empty(); });
    shapes_.erase(idle != shapes_.end() ? idle : shapes_.begin());
  }
  return shapes_.emplace_back(fitted(points, methods, seed));
}

std::vector<const fit::Algorithm*> algorithms_of(const ShapeCosts& shape) {
  std::vector<const fit::Algorithm*> algorithms;
  for (const FittedVolume& volume : shape.volumes) algorithms.push_back(&catalogued(*volume.method));
  return algorithms;
}

}  // namespace snug::lesson
