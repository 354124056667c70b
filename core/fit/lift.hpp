// Steps and results of any scalar and dimension as double and 3-D, without loss, for those who only read them.
#pragma once

#include <variant>

#include "fit/sphere_steps.hpp"

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

template <class Scalar, int Dim>
Sphere<double, 3> lift(const Sphere<Scalar, Dim>& sphere) {
  return {lift<Scalar, Dim>(sphere.center), static_cast<double>(sphere.radius)};
}

template <class Scalar, int Dim>
struct LiftFact {
  using Fact = SphereStep<double, 3>::Fact;

  template <class Plain>
  Fact operator()(const Plain& fact) const {
    return fact;
  }
  Fact operator()(const ExtremesFound<Scalar, Dim>& fact) const {
    ExtremesFound<double, 3> lifted;
    lifted.least.fill(kNoIndex);
    lifted.greatest.fill(kNoIndex);
    std::copy(fact.least.begin(), fact.least.end(), lifted.least.begin());
    std::copy(fact.greatest.begin(), fact.greatest.end(), lifted.greatest.begin());
    return lifted;
  }
  Fact operator()(const MidpointFound<Scalar, Dim>& fact) const {
    return MidpointFound<double, 3>{lift<Scalar, Dim>(fact.least), lift<Scalar, Dim>(fact.greatest),
                                    lift<Scalar, Dim>(fact.midpoint)};
  }
  Fact operator()(const BallGrown<Scalar, Dim>& fact) const { return BallGrown<double, 3>{fact.point, lift(fact.before)}; }
  Fact operator()(const MeanFound<Scalar, Dim>& fact) const { return MeanFound<double, 3>{lift<Scalar, Dim>(fact.mean)}; }
  Fact operator()(const CovarianceFound<Scalar, Dim>& fact) const {
    return CovarianceFound<double, 3>{lift<Scalar, Dim>(fact.mean), lift<Scalar, Dim>(fact.covariance, 0)};
  }
  Fact operator()(const AxesFound<Scalar, Dim>& fact) const {
    // By rising variance: in 2-D the added axis, of variance 0, comes first.
    AxesFound<double, 3> lifted{lift<Scalar, Dim>(fact.mean), Matrix<double, 3>::Zero(), Vector<double, 3>::Zero()};
    constexpr int kAdded = 3 - Dim;
    lifted.axes.template block<Dim, Dim>(0, kAdded) = fact.axes.template cast<double>();
    if constexpr (kAdded == 1) lifted.axes(2, 0) = 1;
    lifted.variances.template tail<Dim>() = fact.variances.template cast<double>();
    return lifted;
  }
  Fact operator()(const BallShrunk<Scalar, Dim>& fact) const { return BallShrunk<double, 3>{fact.pass, lift(fact.before)}; }
  Fact operator()(const PassJudged<Scalar, Dim>& fact) const {
    return PassJudged<double, 3>{fact.pass, fact.better, lift(fact.best)};
  }
  Fact operator()(const CandidateTried<Scalar, Dim>& fact) const {
    using Lifted = CandidateTried<double, 3>;
    return Lifted{fact.points, lift(fact.candidate), static_cast<Lifted::Verdict>(fact.verdict), fact.outside};
  }
};

template <class Scalar, int Dim>
SphereStep<double, 3> lift(const SphereStep<Scalar, Dim>& step) {
  if constexpr (std::is_same_v<Scalar, double> && Dim == 3)
    return step;
  else
    return {step.line, step.has_volume, lift(step.volume), std::visit(LiftFact<Scalar, Dim>{}, step.fact)};
}

}  // namespace snug::fit
