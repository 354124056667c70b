// Steps and results of any scalar and dimension as double and 3-D, without loss, for those who only read them.
#pragma once

#include <algorithm>
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

// ---- facts: those that speak of no coordinates are lifted as they are -----------------------------------------

template <class Plain>
const Plain& lift_fact(const Plain& fact) {
  return fact;
}

template <class Scalar, int Dim>
auto lift_fact(const ExtremesFound<Scalar, Dim>& fact) {
  ExtremesFound<double, 3> lifted;
  lifted.least.fill(kNoIndex);
  lifted.greatest.fill(kNoIndex);
  std::copy(fact.least.begin(), fact.least.end(), lifted.least.begin());
  std::copy(fact.greatest.begin(), fact.greatest.end(), lifted.greatest.begin());
  return lifted;
}
template <class Scalar, int Dim>
auto lift_fact(const MidpointFound<Scalar, Dim>& fact) {
  return MidpointFound<double, 3>{lift<Scalar, Dim>(fact.least), lift<Scalar, Dim>(fact.greatest),
                                  lift<Scalar, Dim>(fact.midpoint)};
}
template <class Scalar, int Dim>
auto lift_fact(const BallGrown<Scalar, Dim>& fact) {
  return BallGrown<double, 3>{fact.point, lift(fact.before)};
}
template <class Scalar, int Dim>
auto lift_fact(const MeanFound<Scalar, Dim>& fact) {
  return MeanFound<double, 3>{lift<Scalar, Dim>(fact.mean)};
}
template <class Scalar, int Dim>
auto lift_fact(const CovarianceFound<Scalar, Dim>& fact) {
  return CovarianceFound<double, 3>{lift<Scalar, Dim>(fact.mean), lift<Scalar, Dim>(fact.covariance, 0)};
}
/// By rising variance: in 2-D the added axis, of variance 0, comes first.
template <class Scalar, int Dim>
auto lift_fact(const AxesFound<Scalar, Dim>& fact) {
  AxesFound<double, 3> lifted{lift<Scalar, Dim>(fact.mean), Matrix<double, 3>::Zero(), Vector<double, 3>::Zero()};
  constexpr int kAdded = 3 - Dim;
  lifted.axes.template block<Dim, Dim>(0, kAdded) = fact.axes.template cast<double>();
  if constexpr (kAdded == 1) lifted.axes(2, 0) = 1;
  lifted.variances.template tail<Dim>() = fact.variances.template cast<double>();
  return lifted;
}
template <class Scalar, int Dim>
auto lift_fact(const BallShrunk<Scalar, Dim>& fact) {
  return BallShrunk<double, 3>{fact.pass, lift(fact.before)};
}
template <class Scalar, int Dim>
auto lift_fact(const PassJudged<Scalar, Dim>& fact) {
  return PassJudged<double, 3>{fact.pass, fact.better, lift(fact.best)};
}
template <class Scalar, int Dim>
auto lift_fact(const CandidateTried<Scalar, Dim>& fact) {
  using Lifted = CandidateTried<double, 3>;
  return Lifted{fact.points, lift(fact.candidate), static_cast<Lifted::Verdict>(fact.verdict), fact.outside};
}

template <class Scalar, int Dim>
auto lift_fact(const ExtentsFound<Scalar, Dim>& fact) {
  return ExtentsFound<double, 3>{fact.least, fact.greatest, lift<Scalar, Dim>(fact.lengths)};
}
template <class Scalar, int Dim>
auto lift_fact(const BallFound<Scalar, Dim>& fact) {
  return BallFound<double, 3>{lift(fact.ball), fact.support};
}
template <class Scalar, int Dim>
auto lift_fact(const SurfaceFound<Scalar, Dim>& fact) {
  return SurfaceFound<double, 3>{fact.area, lift<Scalar, Dim>(fact.centroid)};
}
template <class Scalar, int Dim>
auto lift_fact(const BoxTried<Scalar, Dim>& fact) {
  return BoxTried<double, 3>{fact.on, lift(fact.box), fact.measure, fact.better};
}
template <class Scalar, int Dim>
auto lift_fact(const RectangleFound<Scalar, Dim>& fact) {
  return RectangleFound<double, 3>{
      lift<Scalar, Dim>(fact.along), fact.edge_a, fact.edge_b, lift(fact.box), fact.measure, fact.better};
}
template <class Scalar, int Dim>
auto lift_fact(const query::FramesRelated<Scalar, Dim>& fact) {
  return query::FramesRelated<double, 3>{lift<Scalar, Dim>(fact.rotation, 1), lift<Scalar, Dim>(fact.translation),
                                         fact.doubt};
}
template <class Scalar, int Dim>
query::SatAxis<double, 3> lift(const query::SatAxis<Scalar, Dim>& axis) {
  return {axis.kind, axis.i, axis.j, lift<Scalar, Dim>(axis.direction), axis.gap};
}
template <class Scalar, int Dim>
auto lift_fact(const query::AxisTested<Scalar, Dim>& fact) {
  return query::AxisTested<double, 3>{lift(fact.axis), fact.length,    fact.distance, fact.radius_a, fact.radius_b,
                                      fact.doubt,      fact.separates, fact.skipped,  fact.near_a,   fact.near_b};
}
template <class Scalar, int Dim>
auto lift_fact(const query::Verdict<Scalar, Dim>& fact) {
  return query::Verdict<double, 3>{{fact.result.overlap, fact.result.tests, lift(fact.result.axis)}};
}

/// Corners of the plane keep their bits.
template <class Scalar, int Dim>
auto lift_fact(const query::PlaneTested<Scalar, Dim>& fact) {
  return query::PlaneTested<double, 3>{fact.plane,
                                       fact.skipped,
                                       lift<Scalar, Dim>(fact.normal),
                                       fact.signs,
                                       fact.p_vertex,
                                       fact.n_vertex,
                                       fact.p_corners,
                                       fact.n_corners,
                                       lift<Scalar, Dim>(fact.p_point),
                                       lift<Scalar, Dim>(fact.n_point),
                                       fact.p_distance,
                                       fact.n_distance,
                                       fact.doubt,
                                       fact.looked_closer,
                                       fact.side,
                                       fact.so_far};
}
template <class Scalar, int Dim>
auto lift_fact(const query::CornerTested<Scalar, Dim>& fact) {
  return query::CornerTested<double, 3>{fact.corner, fact.plane, lift<Scalar, Dim>(fact.point), fact.distance,
                                        fact.outside};
}

template <class VolumeType, class... Facts>
Step3 lift(const Step<VolumeType, Facts...>& step) {
  return {step.line, step.has_volume, lift(step.volume),
          std::visit([](const auto& fact) { return Fact3(lift_fact(fact)); }, step.fact)};
}

/// A query has no volume of its own.
template <class Scalar, int Dim>
Step3 lift(const query::SatStep<Scalar, Dim>& step) {
  return {step.line, false, {}, std::visit([](const auto& fact) { return Fact3(lift_fact(fact)); }, step.fact)};
}

template <class Scalar, int Dim>
Step3 lift(const query::ClassifyStep<Scalar, Dim>& step) {
  return {step.line, false, {}, std::visit([](const auto& fact) { return Fact3(lift_fact(fact)); }, step.fact)};
}

inline Step3 lift(const query::WrongStep& step) {
  return {step.line, false, {}, std::visit([](const auto& fact) { return Fact3(fact); }, step.fact)};
}

}  // namespace snug::fit
