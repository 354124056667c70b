// A fuzzer's bytes as volumes and frusta.
#pragma once

#include <optional>

#include "fit/catalogue.hpp"
#include "fuzz/bytes.hpp"
#include "geometry/convert.hpp"
#include "geometry/frustum.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fuzz {

template <class Scalar, int Dim>
using Cloud = std::vector<Vector<Scalar, Dim>>;

/// Fitted by one of the algorithms of which may_fit is true and whose result is sure to contain the points.
template <class Scalar, int Dim>
Volume<Scalar, Dim> fitted(Bytes& bytes, const Cloud<Scalar, Dim>& points, const auto& may_fit) {
  std::vector<const fit::Algorithm*> fitting;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (fit::takes(algorithm, Dim) && !algorithm.naive && may_fit(algorithm)) fitting.push_back(&algorithm);
  const fit::Algorithm& algorithm = *fitting[bytes.below(static_cast<unsigned>(fitting.size()))];
  return std::visit([](const auto& v) { return Volume<Scalar, Dim>(converted<Scalar, Dim>(v)); },
                    algorithm.fit(*PointSet<Scalar, Dim>::make(points), {}).volume);
}

/// How far a point within a box's slabs may be from every sum of its edges.
template <class Scalar, int Dim>
double axes_off(const Volume<Scalar, Dim>& volume) {
  const auto* box = std::get_if<Obb<Scalar, Dim>>(&volume);
  return box == nullptr ? 0 : 2 * static_cast<double>(tolerance::kObbAxes<Scalar> * box->half_extents.sum());
}

/// Planes with any normals; or none, where those make no frustum.
template <class Scalar, int Dim>
std::optional<Frustum<Scalar, Dim>> any_frustum(Bytes& bytes) {
  typename Frustum<Scalar, Dim>::Planes planes;
  for (auto& plane : planes) {
    plane.normal = bytes.point<Scalar, Dim>();
    plane.d = bytes.number<Scalar>();
  }
  const auto frustum = Frustum<Scalar, Dim>::make(planes);
  return frustum ? std::optional(*frustum) : std::nullopt;
}

}  // namespace snug::fuzz
