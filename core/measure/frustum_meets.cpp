#include "measure/frustum_meets.hpp"

#include <algorithm>

#include "geometry/frustum_corners.hpp"
#include "geometry/tolerance.hpp"
#include "measure/signed_distance.hpp"
#include "number/tuple.hpp"
#include "query/cull/frustum_sat.hpp"

namespace snug::proximity {
namespace {

template <int Dim>
using ExactCorners = std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>;
template <int Dim>
using Exactly = Tuple<Dyadic, Dim>;

/// A sphere against a frustum without rounding. The frustum's point nearest to the centre is the centre itself, or its
/// foot on a face or an edge, or a vertex. Each that exists is a point of the frustum; so one within the radius
/// decides.
template <class Scalar, int Dim>
class ExactSphere {
 public:
  ExactSphere(const Frustum<Scalar, Dim>& frustum, const ExactCorners<Dim>& corners, const Sphere<Scalar, Dim>& sphere)
      : corners_(corners), center_(tuple_of<Dyadic, Dim>(sphere.center)) {
    const Dyadic radius = static_cast<double>(sphere.radius);
    square_ = radius * radius;
    for (const auto& plane : frustum.planes()) {
      normals_.push_back(tuple_of<Dyadic, Dim>(plane.normal));
      heights_.push_back(dot(normals_.back(), center_) + Dyadic(static_cast<double>(plane.d)));
    }
  }

  [[nodiscard]] bool meets() const {
    if (std::all_of(heights_.begin(), heights_.end(), [](const Dyadic& h) { return h.sign() <= 0; })) return true;
    for (std::size_t plane = 0; plane < normals_.size(); ++plane)
      if (reaches_face(plane)) return true;
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (reaches_corner(c)) return true;
      for (std::size_t bit = 1; Dim == 3 && bit < corners_.size(); bit *= 2)
        if ((c & bit) == 0 && reaches_edge(c, c | bit)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool reaches_face(std::size_t plane) const {
    const Exactly<Dim>& normal = normals_[plane];
    const Dyadic& height = heights_[plane];
    const Dyadic length = dot(normal, normal);
    if (height.sign() <= 0 || square_ * length < height * height) return false;
    for (std::size_t other = 0; other < normals_.size(); ++other)  // the foot lies inside all other planes
      if ((heights_[other] * length - dot(normals_[other], normal) * height).sign() > 0 && other != plane) return false;
    return true;
  }

  /// The centre relative to a corner, times the corner's weight.
  [[nodiscard]] Exactly<Dim> from(std::size_t corner) const {
    return corners_[corner].weight * center_ - corners_[corner].coordinates;
  }

  [[nodiscard]] bool reaches_corner(std::size_t corner) const {
    const Exactly<Dim> between = from(corner);
    return dot(between, between) <= square_ * corners_[corner].weight * corners_[corner].weight;
  }

  [[nodiscard]] bool reaches_edge(std::size_t start, std::size_t end) const {
    if constexpr (Dim == 3) {
      const auto& [a, a_weight] = corners_[start];
      const auto& [b, b_weight] = corners_[end];
      const Exactly<Dim> edge = a_weight * b - b_weight * a;
      const Exactly<Dim> between = from(start);
      if (dot(between, edge).sign() < 0 || dot(from(end), edge).sign() > 0) return false;
      const Exactly<Dim> across = cross(between, edge);
      return dot(across, across) <= square_ * a_weight * a_weight * dot(edge, edge);
    } else {
      return start == end;  // an edge is a face in the plane
    }
  }

  const ExactCorners<Dim>& corners_;
  Exactly<Dim> center_;
  Dyadic square_;  // of the radius
  std::vector<Exactly<Dim>> normals_;
  std::vector<Dyadic> heights_;  // n . center + d for each plane
};

/// The frustum about an origin, from its exact vertices. None where one is out of range.
template <class Scalar, int Dim>
std::optional<query::GrownCore> core_around(const ExactCorners<Dim>& corners, const Vector<Scalar, Dim>& origin) {
  query::GrownCore core;
  for (const auto& [coordinates, weight] : corners) {
    Vector<double, 3> corner = Vector<double, 3>::Zero();
    for (int i = 0; i < Dim; ++i)
      corner[i] = quotient(coordinates[i] - Dyadic(static_cast<double>(origin[i])) * weight, weight);
    if (!corner.allFinite()) return std::nullopt;
    core.corners.push_back(corner);
  }
  return core;
}

/// The answer if both bounds on the distance agree on it; none otherwise.
template <class Scalar, int Dim, class Shape>
std::optional<bool> meets_by_bounds(const ExactCorners<Dim>& corners, const Shape& shape) {
  constexpr double kDoubt = 64 * tolerance::kTouching<double>;
  const Vector<Scalar, Dim> origin = anchor(shape);
  auto frustum = core_around<Scalar, Dim>(corners, origin);
  query::GrownCore core = query::grown_core(shape, origin);
  if (!frustum || core.is_empty()) return std::nullopt;
  query::scale_to_unit(*frustum, core);
  const DistanceBounds bounds = bounds_between<Dim>(*frustum, core);
  if (bounds.least > core.radius + kDoubt) return false;
  if (bounds.most < core.radius - kDoubt) return true;
  return std::nullopt;
}

}  // namespace

template <class Scalar, int Dim>
std::optional<bool> meets(const Frustum<Scalar, Dim>& frustum, const Volume<Scalar, Dim>& volume) {
  return std::visit(
      [&]<template <class, int> class Kind>(const Kind<Scalar, Dim>& shape) -> std::optional<bool> {
        if constexpr (std::is_same_v<Kind<Scalar, Dim>, Aabb<Scalar, Dim>> ||
                      std::is_same_v<Kind<Scalar, Dim>, Obb<Scalar, Dim>>) {
          const auto exact = query::FrustumSat<Scalar, Dim>::make(frustum);
          return exact ? std::optional(exact->overlaps(shape)) : std::nullopt;
        } else {
          const auto corners = exact_corners_of(frustum);
          if (!corners) return std::nullopt;
          const auto answer = meets_by_bounds<Scalar, Dim>(*corners, shape);
          if constexpr (std::is_same_v<Kind<Scalar, Dim>, Sphere<Scalar, Dim>>)
            return answer ? answer : ExactSphere<Scalar, Dim>(frustum, *corners, shape).meets();
          return answer;
        }
      },
      volume);
}

template std::optional<bool> meets(const Frustum<float, 2>&, const Volume<float, 2>&);
template std::optional<bool> meets(const Frustum<float, 3>&, const Volume<float, 3>&);
template std::optional<bool> meets(const Frustum<double, 2>&, const Volume<double, 2>&);
template std::optional<bool> meets(const Frustum<double, 3>&, const Volume<double, 3>&);

}  // namespace snug::proximity
