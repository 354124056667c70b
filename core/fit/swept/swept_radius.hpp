// Sets the radius with which a capsule or a lozenge contains every point. Their fitters end with it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/capsule.hpp"
#include "geometry/lozenge.hpp"
#include "geometry/point_set.hpp"
#include "geometry/tolerance.hpp"
#include "number/power_of_two.hpp"
#include "query/contain/contains.hpp"

namespace snug::fit {

/// The core over which the sphere is swept, a segment or a rectangle, in double.
template <int Dim>
class ScaledCore {
 public:
  template <class Scalar>
  explicit ScaledCore(const Capsule<Scalar, Dim>& capsule)
      : ScaledCore(capsule.a.template cast<double>(),
                   capsule.b.template cast<double>() - capsule.a.template cast<double>(), Vector<double, Dim>::Zero()) {
  }
  template <class Scalar>
  explicit ScaledCore(const Lozenge<Scalar, Dim>& lozenge)
      : ScaledCore(lozenge.origin.template cast<double>(), lozenge.edges[0].template cast<double>(),
                   lozenge.edges[1].template cast<double>()) {}

  /// The distance of the point from the core, within kSweptDistance of that distance and twice the size.
  [[nodiscard]] double distance(const Vector<double, Dim>& point) const {
    Vector<double, Dim> rest = point - origin_;
    for (const Edge& edge : edges_) rest -= edge.share(rest) * edge.whole;
    return scaled_norm<double, Dim>(rest);
  }
  /// The sum of the lengths of its edges.
  [[nodiscard]] double size() const {
    return scaled_norm<double, Dim>(edges_[0].whole) + scaled_norm<double, Dim>(edges_[1].whole);
  }

 private:
  /// An edge, with a copy scaled to a size between 1 and 2, whose square neither over- nor underflows.
  struct Edge {
    Vector<double, Dim> whole, scaled;
    double scale, square;

    explicit Edge(const Vector<double, Dim>& edge) : whole(edge) {
      scale = to_unit_size(edge.cwiseAbs().maxCoeff());
      scaled = edge * scale;
      square = scaled.squaredNorm();
    }
    /// Where the perpendicular from v meets the edge: 0 at or before its start, 1 at or past its end.
    [[nodiscard]] double share(const Vector<double, Dim>& v) const {
      if (square == 0) return 0;
      const Vector<double, Dim> magnified = v * scale;
      if (!magnified.allFinite()) return 0;  // beside so long a v the edge is negligible
      return std::clamp(magnified.dot(scaled) / square, 0.0, 1.0);
    }
  };

  ScaledCore(const Vector<double, Dim>& origin, const Vector<double, Dim>& edge, const Vector<double, Dim>& other)
      : origin_(origin), edges_{Edge(edge), Edge(other)} {}

  Vector<double, Dim> origin_;
  std::array<Edge, 2> edges_;
};

/// The largest size in a swept volume's computation over the points, which its rounding errors are relative to.
template <class VolumeType, class Scalar, int Dim>
[[nodiscard]] double swept_size(const VolumeType& volume, PointSpan<Scalar, Dim> points) {
  Scalar largest = 0;
  for (const auto& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return static_cast<double>(largest) + static_cast<double>(volume.radius) + ScaledCore<Dim>(volume).size();
}

/// Whether the point lies on the boundary, within rounding. size: swept_size.
template <class VolumeType, class Scalar, int Dim>
[[nodiscard]] bool touches(const VolumeType& volume, const Vector<Scalar, Dim>& point, double size) {
  const double distance = ScaledCore<Dim>(volume).distance(point.template cast<double>());
  return std::abs(distance - static_cast<double>(volume.radius)) <=
         tolerance::kSweptBoundaryRoundoffs * tolerance::roundoff<Scalar>(size);
}

struct SweptRadius {
  Index farthest = 0;    // the point farthest from the core
  bool widened = false;  // whether rounding had left a point outside
};

// Up to this many points near the boundary are decided exactly; with more, the radius is widened by its error bound.
inline constexpr std::size_t kSweptCandidates = 1024;

/// Widens the radius until the volume contains the point. The steps double, because a radius of nearly 0 has far to go
/// in units of its last digit; they start at one such unit, or at a length that is negligible beside the error bound.
template <class VolumeType, class Scalar, int Dim>
bool widen_swept(VolumeType& volume, const Vector<Scalar, Dim>& point, Scalar least_step) {
  constexpr Scalar kMost = std::numeric_limits<Scalar>::max();
  Scalar step = std::max(std::nextafter(volume.radius, kMost) - volume.radius, least_step);
  bool widened = false;
  for (; !query::contains(volume, point); step *= 2, widened = true) volume.radius += step;
  return widened;
}

/// Sets the radius to the least, but for rounding, with which the volume contains every point in exact arithmetic. Two
/// passes.
template <class VolumeType, class Scalar, int Dim>
SweptRadius hold_all(VolumeType& volume, PointSpan<Scalar, Dim> points) {
  const ScaledCore<Dim> core(volume);
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const auto& p : points) distances.push_back(core.distance(p.template cast<double>()));
  const auto most = std::max_element(distances.begin(), distances.end());
  SweptRadius result{static_cast<Index>(most - distances.begin()), false};

  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  const double error_bound = tolerance::kSweptDistance * (*most + 2 * core.size()) + 16 * kLeast;
  volume.radius = static_cast<Scalar>(*most);
  std::vector<Index> candidates;
  for (Index i = 0; i < points.size(); ++i)
    if (distances[i] + error_bound >= static_cast<double>(volume.radius)) candidates.push_back(i);
  if (candidates.size() > kSweptCandidates) {
    const Scalar bound = static_cast<Scalar>(*most + error_bound);
    volume.radius = std::nextafter(bound, std::numeric_limits<Scalar>::max());
    return {result.farthest, true};
  }
  const auto least_step = static_cast<Scalar>(error_bound * tolerance::kRoundoff<Scalar>);
  for (const Index i : candidates)
    if (widen_swept<VolumeType, Scalar, Dim>(volume, points[i], least_step)) result.widened = true;
  return result;
}

}  // namespace snug::fit
