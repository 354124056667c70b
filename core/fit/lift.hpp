// Steps and results of any scalar and dimension as double and 3-D, without loss, for those who only read them.
#pragma once

#include <algorithm>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "fit/any_step.hpp"

namespace snug::fit {

template <class Scalar, int Dim>
Vector<double, 3> lift(const Vector<Scalar, Dim>& v) {
  Vector<double, 3> lifted = Vector<double, 3>::Zero();
  lifted.template head<Dim>() = v.template cast<double>();
  return lifted;
}

/// The added axis is an axis of its own: a 1 on the diagonal of axes, a 0 on that of a covariance.
template <class Scalar, int Dim>
Matrix<double, 3> lift(const Matrix<Scalar, Dim>& m, double added) {
  Matrix<double, 3> lifted = Matrix<double, 3>::Zero();
  lifted(2, 2) = added;
  lifted.template topLeftCorner<Dim, Dim>() = m.template cast<double>();
  return lifted;
}

// ---- volumes ------------------------------------------------------------------------------------------------

template <class Scalar, int Dim>
Sphere<double, 3> lift(const Sphere<Scalar, Dim>& sphere) {
  return {lift<Scalar, Dim>(sphere.center), static_cast<double>(sphere.radius)};
}

template <class Scalar, int Dim>
Aabb<double, 3> lift(const Aabb<Scalar, Dim>& box) {
  return {lift<Scalar, Dim>(box.min), lift<Scalar, Dim>(box.max)};
}

template <class Scalar, int Dim>
Obb<double, 3> lift(const Obb<Scalar, Dim>& box) {
  return {lift<Scalar, Dim>(box.center), lift<Scalar, Dim>(box.axes, 1), lift<Scalar, Dim>(box.half_extents)};
}

template <class Scalar, int Dim>
Capsule<double, 3> lift(const Capsule<Scalar, Dim>& capsule) {
  return {lift<Scalar, Dim>(capsule.a), lift<Scalar, Dim>(capsule.b), static_cast<double>(capsule.radius)};
}

template <class Scalar, int Dim>
Lozenge<double, 3> lift(const Lozenge<Scalar, Dim>& lozenge) {
  return {lift<Scalar, Dim>(lozenge.origin),
          {lift<Scalar, Dim>(lozenge.edges[0]), lift<Scalar, Dim>(lozenge.edges[1])},
          static_cast<double>(lozenge.radius)};
}

/// The slabs keep their places; those of 2-D are slabs of the plane still.
template <class Scalar, int Dim>
Kdop<double, 3> lift(const Kdop<Scalar, Dim>& kdop) {
  Kdop<double, 3> lifted{.k = kdop.k};
  std::copy(kdop.min.begin(), kdop.min.end(), lifted.min.begin());
  std::copy(kdop.max.begin(), kdop.max.end(), lifted.max.begin());
  return lifted;
}

/// An edge of the plane is a facet whose third vertex is none.
template <class Scalar, int Dim>
ConvexHull<double, 3> lift(const ConvexHull<Scalar, Dim>& hull) {
  ConvexHull<double, 3> lifted{{}, hull.indices, {}, hull.affine_dim};
  for (const auto& vertex : hull.vertices) lifted.vertices.push_back(lift<Scalar, Dim>(vertex));
  for (const auto& facet : hull.facets) {
    auto& added = lifted.facets.emplace_back(std::array<Index, 3>{kNoIndex, kNoIndex, kNoIndex});
    std::copy(facet.begin(), facet.end(), added.begin());
  }
  return lifted;
}

// ---- facts, field by field: those that speak of no coordinates are lifted as they are -------------------------

template <class To, class From>
void lift_into(To& lifted, const From& field) {
  if constexpr (std::is_same_v<To, From>) {
    lifted = field;
  } else if constexpr (std::is_enum_v<To>) {
    lifted = static_cast<To>(field);
  } else if constexpr (requires { lifted.fill(kNoIndex), std::tuple_size<To>::value; }) {
    lifted.fill(kNoIndex);
    std::copy(field.begin(), field.end(), lifted.begin());
  } else if constexpr (requires { From::RowsAtCompileTime; }) {
    lifted = lift<typename From::Scalar, From::RowsAtCompileTime>(field);
  } else {
    lifted = lift(field);
  }
}

template <class Plain>
const Plain& lift_fact(const Plain& fact) {
  return fact;
}
template <template <class, int> class Fact, class Scalar, int Dim>
Fact<double, 3> lift_fact(const Fact<Scalar, Dim>& fact) {
  Fact<double, 3> lifted;
  const auto each = [&]<std::size_t... kAt>(std::index_sequence<kAt...>, auto to, auto from) {
    (lift_into(std::get<kAt>(to), std::get<kAt>(from)), ...);
  };
  each(std::make_index_sequence<Fact<double, 3>::kFields.size()>(), Fact<double, 3>::tie(lifted),
       Fact<Scalar, Dim>::tie(fact));
  return lifted;
}
template <class Scalar, int Dim>
CovarianceFound<double, 3> lift_fact(const CovarianceFound<Scalar, Dim>& fact) {
  return {lift<Scalar, Dim>(fact.mean), lift<Scalar, Dim>(fact.covariance, 0)};
}
/// By rising variance: in 2-D the added axis, of variance 0, comes first.
template <class Scalar, int Dim>
AxesFound<double, 3> lift_fact(const AxesFound<Scalar, Dim>& fact) {
  AxesFound<double, 3> lifted{lift<Scalar, Dim>(fact.mean), Matrix<double, 3>::Zero(), Vector<double, 3>::Zero()};
  constexpr int kAdded = 3 - Dim;
  lifted.axes.template block<Dim, Dim>(0, kAdded) = fact.axes.template cast<double>();
  if constexpr (kAdded == 1) lifted.axes(2, 0) = 1;
  lifted.variances.template tail<Dim>() = fact.variances.template cast<double>();
  return lifted;
}

template <class VolumeType, class... Facts>
Step3 lift(const Step<VolumeType, Facts...>& step) {
  return {step.line, step.has_volume, lift(step.volume),
          std::visit([](const auto& fact) { return Fact3(lift_fact(fact)); }, step.fact)};
}

}  // namespace snug::fit
