#include "lesson/subjects/cloud/left_outside.hpp"

#include <cmath>
#include <limits>

#include "geometry/convert.hpp"
#include "geometry/sphere.hpp"
#include "number/double_double.hpp"

namespace snug::lesson {
namespace {

template <class Scalar>
double ulp_of(double size) {
  const auto own = static_cast<Scalar>(size);
  return static_cast<double>(std::nextafter(own, std::numeric_limits<Scalar>::infinity()) - own);
}

template <class Scalar, int Dim>
LeftOutside left_outside_of(const PointSet<Scalar, Dim>& set, const fit::Sphere3& sphere) {
  const auto own = converted<Scalar, Dim>(sphere);
  LeftOutside left;
  double largest = 0;
  for (Index i = 0; i < set.size(); ++i) {
    largest = std::max(largest, static_cast<double>(set[i].cwiseAbs().maxCoeff()));
    if (side_of_sphere(set[i], own) <= 0) continue;
    left.points.push_back(i);
    const double by = outside_by(fit::point_of(set, i), sphere);
    if (left.worst == kNoIndex || by > left.by) left.worst = i, left.by = by;
  }
  left.radius_ulp = ulp_of<Scalar>(sphere.radius), left.size_ulp = ulp_of<Scalar>(largest);
  return left;
}

}  // namespace

// The difference of the squares is computed in twice double's digits, because it may be far below an ulp of either.
double outside_by(const Point3& point, const fit::Sphere3& sphere) {
  const DoubleDouble radius(sphere.radius);
  DoubleDouble excess = -(radius * radius);
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble apart = DoubleDouble::sum(point[axis], -sphere.center[axis]);
    excess += apart * apart;
  }
  return excess.value() / ((point - sphere.center).norm() + sphere.radius);
}

LeftOutside left_outside(const AnyPointSet& points, const fit::Sphere3& sphere) {
  return std::visit([&](const auto& set) { return left_outside_of(set, sphere); }, points);
}

std::string ulps_text(double ulps) {
  if (ulps == 0) return "0 ulps";
  return number_text(ulps, 3) + (ulps == 1 ? " ulp" : " ulps");
}

void add_left_outside(std::vector<Figure>& figures, const FitRun& run) {
  const auto* sphere = std::get_if<fit::Sphere3>(&run.recording().result.volume);
  if (sphere == nullptr) return;
  const LeftOutside left = left_outside(run.points(), *sphere);
  std::erase_if(figures, [](const Figure& figure) { return figure.key == "outside"; });  // allows for rounding
  const auto add = [&](std::string name, std::string key, std::string text, double value, std::string unit) {
    figures.push_back({std::move(name), std::move(key), std::move(text), value, std::move(unit)});
  };
  const auto count = static_cast<std::int64_t>(left.points.size());
  add("Outside, exactly", "outside_count", count_text(count) + " of " + count_text(fit::size_of(run.points())),
      static_cast<double>(count), "points");
  const double size_ulps = left.by / left.size_ulp;
  add("Worst, by radius", "worst_ulps", ulps_text(left.ulps()), left.ulps(), "ulps");
  if (!std::isfinite(left.ulps())) figures.back() = {"Worst, by radius", "worst_ulps", "—", 0, "ulps", false};
  add("Worst, by size", "worst_size_ulps", ulps_text(size_ulps), size_ulps, "ulps");
  add("Steps", "steps", count_text(run.steps()), run.steps(), "steps");
}

}  // namespace snug::lesson
