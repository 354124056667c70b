#include "fit/rounded.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "fit/aabb/certify_aabb.hpp"
#include "fit/hull/certify_hull.hpp"
#include "fit/kdop/certify_kdop.hpp"
#include "fit/obb/certify_obb.hpp"
#include "fit/sphere/certify_sphere.hpp"
#include "fit/swept/certify_swept.hpp"
#include "geometry/convert.hpp"

namespace snug::fit {
namespace {

/// The proof of each kind says how far points lie outside, as it does in the certificate.
template <template <class, int> class Kind, int Dim>
double farthest_outside(const Kind<double, Dim>& volume, PointSpan<double, Dim> points, std::span<const double>) {
  return certify(Fit<Kind<double, Dim>>{volume, {}}, points, false).max_outside;
}
template <int Dim>
double farthest_outside(const ConvexHull<double, Dim>& hull, PointSpan<double, Dim> points,
                        std::span<const double> at_most) {
  return max_outside(hull, points, at_most);
}

template <class Scalar, int Dim>
Rounded lost_by(const Result& result, const Certificate& certificate, const PointSet<Scalar, Dim>& points,
                std::span<const Vector<double, 3>> given) {
  Rounded lost;
  std::vector<Vector<double, Dim>> before;
  std::vector<double> at_most;  // a point lies no farther outside than its rounded one did, and was moved
  for (const auto& p : given) before.emplace_back(p.head<Dim>());
  for (Index i = 0; i < points.size(); ++i) {
    const double moved = scaled_norm<double, Dim>(points[i].template cast<double>() - before[i]);
    lost.by = std::max(lost.by, moved);
    at_most.push_back(moved + certificate.max_outside);
  }
  const auto set = *PointSet<double, Dim>::make(std::move(before));
  lost.max_outside =
      std::visit([&](const auto& own) { return farthest_outside(converted<double, Dim>(own), set.span(), at_most); },
                 result.volume);
  return lost;
}

}  // namespace

bool are_float(const AnyPointSet& points) {
  return std::visit([](const auto& set) { return sizeof(set[0][0]) == sizeof(float); }, points);
}

Rounded rounded(const Result& result, const Certificate& certificate, const AnyPointSet& points,
                std::span<const Vector<double, 3>> given) {
  return std::visit([&](const auto& set) { return lost_by(result, certificate, set, given); }, points);
}

}  // namespace snug::fit
