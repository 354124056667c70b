#include "lesson/subjects/cloud/left_outside.hpp"

#include <cmath>
#include <limits>

#include "fit/rounded.hpp"
#include "geometry/convert.hpp"
#include "geometry/orientation.hpp"
#include "geometry/sphere.hpp"
#include "number/double_double.hpp"

namespace snug::lesson {
namespace {

template <class Scalar>
double ulp_in(double size) {
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
  left.extent = sphere.radius, left.radius_ulp = sphere.radius > 0 ? ulp_in<Scalar>(sphere.radius) : 0;
  left.size_ulp = ulp_in<Scalar>(largest);
  return left;
}

/// Twice the area of the triangle, in twice a double's digits.
DoubleDouble cross(const Point3& a, const Point3& b, const Point3& p) {
  const auto apart = [&](const Point3& to, int axis) { return DoubleDouble::sum(to[axis], -a[axis]); };
  return apart(b, 0) * apart(p, 1) + -(apart(b, 1) * apart(p, 0));
}

/// A closed outline in the plane, which may cross itself.
class Outline {
 public:
  explicit Outline(std::vector<Point3> ring) : ring_(std::move(ring)) {}
  [[nodiscard]] std::size_t size() const { return ring_.size(); }
  [[nodiscard]] int turn_at(std::size_t i) const { return turn(before(i), ring_[i], after(i)); }

  /// Whether it goes around the point, or the point lies on it. Every sign is exact.
  [[nodiscard]] bool contains(const Point3& p) const {
    int winding = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const Point3 &a = ring_[i], &b = after(i);
      const int side = turn(a, b, p);
      if (side == 0 && p.x() >= std::min(a.x(), b.x()) && p.x() <= std::max(a.x(), b.x()) &&
          p.y() >= std::min(a.y(), b.y()) && p.y() <= std::max(a.y(), b.y()))
        return true;
      if (a.y() <= p.y() && b.y() > p.y() && side > 0) ++winding;
      if (a.y() > p.y() && b.y() <= p.y() && side < 0) --winding;
    }
    return winding != 0;
  }

  /// How far the point is from the nearest edge, scene units.
  [[nodiscard]] double distance(const Point3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i) {
      const Point3 &a = ring_[i], &b = after(i);
      const Point3 along = b - a;
      const double length = along.norm(), at = length > 0 ? (p - a).dot(along) / length : 0;
      const double to_line = length > 0 ? std::abs(cross(a, b, p).value()) / length : (p - a).norm();
      least = std::min(least, at < 0 ? (p - a).norm() : at > length ? (p - b).norm() : to_line);
    }
    return least;
  }

 private:
  static int turn(const Point3& a, const Point3& b, const Point3& c) {
    return orient2d(a.head<2>(), b.head<2>(), c.head<2>());
  }
  [[nodiscard]] const Point3& after(std::size_t i) const { return ring_[(i + 1) % size()]; }
  [[nodiscard]] const Point3& before(std::size_t i) const { return ring_[(i + size() - 1) % size()]; }
  std::vector<Point3> ring_;
};

}  // namespace

double ulp_of(const AnyPointSet& points, double size) {
  return fit::are_float(points) ? ulp_in<float>(size) : ulp_in<double>(size);
}

LeftOutside left_outside_hull(const AnyPointSet& points, std::span<const Index> support) {
  std::vector<Point3> ring;
  for (const Index i : support) ring.push_back(fit::point_of(points, i));
  Point3 least = ring.front(), greatest = least;
  for (const Point3& vertex : ring) least = least.cwiseMin(vertex), greatest = greatest.cwiseMax(vertex);
  const Outline outline(std::move(ring));
  LeftOutside left;
  left.extent = (greatest - least).maxCoeff() / 2;
  double largest = 0;
  for (Index i = 0; i < fit::count_of(points); ++i) {
    const Point3 point = fit::point_of(points, i);
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
    if (outline.contains(point)) continue;
    left.points.push_back(i);
    const double by = outline.distance(point);
    if (left.worst == kNoIndex || by > left.by) left.worst = i, left.by = by;
  }
  for (std::size_t i = 0; i < support.size() && support.size() > 2; ++i)
    if (outline.turn_at(i) < 0) left.dents.push_back(support[i]);
  left.size_ulp = left.radius_ulp = ulp_of(points, largest);
  return left;
}

std::optional<LeftOutside> left_by(const AnyPointSet& points, const fit::Result& result) {
  if (const auto* sphere = std::get_if<fit::Sphere3>(&result.volume)) return left_outside(points, *sphere);
  if (fit::dim_of(points) == 2 && std::holds_alternative<ConvexHull<double, 3>>(result.volume))
    return left_outside_hull(points, result.support);
  return std::nullopt;
}

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

std::string worst_text(const LeftOutside& left, std::string_view of) {
  if (!std::isfinite(left.ulps())) return number_text(left.by, 3) + " units";
  return ulps_text(left.ulps()) + std::string(of);
}

const char* of_ulps(const fit::Result& result) {
  return std::holds_alternative<fit::Sphere3>(result.volume) ? " of the radius" : " of the coordinates";
}

void add_left_outside(std::vector<Figure>& figures, const FitRun& run) {
  const fit::Result& result = run.recording().result;
  const auto found = left_by(run.points(), result);
  if (!found) return;
  const LeftOutside& left = *found;
  std::erase_if(figures, [](const Figure& figure) { return figure.key == "outside"; });  // allows for rounding
  const auto add = [&](std::string name, std::string key, std::string text, double value, std::string unit) {
    figures.push_back({std::move(name), std::move(key), std::move(text), value, std::move(unit)});
  };
  const auto count = static_cast<std::int64_t>(left.points.size());
  add("Outside, exactly", "outside_count", count_text(count) + " of " + count_text(fit::count_of(run.points())),
      static_cast<double>(count), "points");
  const double size_ulps = left.by / left.size_ulp;
  if (std::holds_alternative<fit::Sphere3>(result.volume)) {
    add("Worst, by radius", "worst_ulps", ulps_text(left.ulps()), left.ulps(), "ulps");
    if (!std::isfinite(left.ulps())) figures.back() = {"Worst, by radius", "worst_ulps", "—", 0, "ulps", false};
  } else {
    const auto dents = static_cast<std::int64_t>(left.dents.size());
    add("Dents", "dents", count_text(dents), static_cast<double>(dents), "dents");
  }
  add("Worst, by size", "worst_size_ulps", ulps_text(size_ulps), size_ulps, "ulps");
  add("Steps", "steps", count_text(run.steps()), run.steps(), "steps");
}

}  // namespace snug::lesson
