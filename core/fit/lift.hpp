// Lifts steps and results of any scalar and dimension to double and 3-D, without loss, for code that only reads them.
#pragma once

#include <variant>

#include "fit/any_step.hpp"
#include "geometry/convert.hpp"

namespace snug::fit {

template <class Scalar, int Dim>
Vector<double, 3> lift(const Vector<Scalar, Dim>& v) {
  Vector<double, 3> lifted = Vector<double, 3>::Zero();
  lifted.template head<Dim>() = v.template cast<double>();
  return lifted;
}

/// The added axis is perpendicular to the others: diagonal is 1 for a matrix of axes, 0 for a covariance.
template <class Scalar, int Dim>
Matrix<double, 3> lift(const Matrix<Scalar, Dim>& m, double added) {
  Matrix<double, 3> lifted = Matrix<double, 3>::Zero();
  lifted(2, 2) = added;
  lifted.template topLeftCorner<Dim, Dim>() = m.template cast<double>();
  return lifted;
}

/// A volume; an edge of a hull in the plane is a facet whose third vertex is none.
template <template <class, int> class Kind, class Scalar, int Dim>
Kind<double, 3> lift(const Kind<Scalar, Dim>& volume) {
  return converted<double, 3>(volume);
}

// ---- facts: those without coordinates are lifted as they are ------------------------------------------

template <class Plain>
const Plain& lift_fact(const Plain& fact) {
  return fact;
}
template <template <class, int> class Fact, class Scalar, int Dim>
Fact<double, 3> lift_fact(const Fact<Scalar, Dim>& fact) {
  return converted<double, 3>(fact);
}
template <class Scalar, int Dim>
CovarianceFound<double, 3> lift_fact(const CovarianceFound<Scalar, Dim>& fact) {
  return {lift<Scalar, Dim>(fact.mean), lift<Scalar, Dim>(fact.covariance, 0)};
}
template <class Scalar, int Dim>
ProductsAdded<double, 3> lift_fact(const ProductsAdded<Scalar, Dim>& fact) {
  return {fact.point, fact.from_mean, lift<Scalar, Dim>(fact.offset), lift<Scalar, Dim>(fact.sum, 0)};
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
