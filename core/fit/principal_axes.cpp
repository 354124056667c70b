#include "fit/principal_axes.hpp"

#include <Eigen/Eigenvalues>

namespace snug::fit {

// Eigen's iterative solver uses only the four operations and square roots: the same bits everywhere (its direct solver
// does not).
template <class Scalar, int Dim>
AxesFound<Scalar, Dim> principal_axes(const CovarianceFound<Scalar, Dim>& spread) {
  using Plain = Eigen::Matrix<Scalar, Dim, Dim>;
  const Eigen::SelfAdjointEigenSolver<Plain> solver(Plain(spread.covariance));
  AxesFound<Scalar, Dim> found{spread.mean, solver.eigenvectors(), solver.eigenvalues()};
  for (int i = 0; i < Dim; ++i) {
    int largest = 0;
    found.axes.col(i).cwiseAbs().maxCoeff(&largest);
    if (found.axes(largest, i) < 0) found.axes.col(i) *= -1;
  }
  return found;
}

template AxesFound<float, 2> principal_axes(const CovarianceFound<float, 2>&);
template AxesFound<float, 3> principal_axes(const CovarianceFound<float, 3>&);
template AxesFound<double, 2> principal_axes(const CovarianceFound<double, 2>&);
template AxesFound<double, 3> principal_axes(const CovarianceFound<double, 3>&);

}  // namespace snug::fit
