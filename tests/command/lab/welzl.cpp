#include "welzl.hpp"

#include <Eigen/Dense>
#include <algorithm>

using Vector3 = snug::Vector<double, 3>;
using Ball = snug::Sphere<double, 3>;
using Points = std::vector<Vector3>;

/// The sphere through the support, with its centre in their span; radius -1 if they span too little.
static Ball through(const Points& support, double extent) {
  const auto n = static_cast<Eigen::Index>(support.size()) - 1;
  if (n < 0) return {Vector3::Zero(), -1};
  Eigen::MatrixXd edges(3, n);
  for (Eigen::Index i = 0; i < n; ++i) edges.col(i) = support[i + 1] - support[0];
  if (n == 0) return {support[0], 0};
  const Eigen::MatrixXd gram = edges.transpose() * edges;
  const Eigen::FullPivLU<Eigen::MatrixXd> solver(gram);
  if (solver.maxPivot() <= 0 || std::abs(gram.determinant()) <= 1e-26 * std::pow(extent, 2.0 * static_cast<double>(n)))
    return {Vector3::Zero(), -1};
  const Vector3 way = edges * solver.solve(gram.diagonal() / 2);
  return {support[0] + way, way.norm()};
}

Ball smallest(std::vector<Vector3> points) {
  const Vector3 origin = points.front();
  double extent = 0;
  for (Vector3& p : points) p -= origin, extent = std::max(extent, p.norm());
  if (!(extent > 0)) return {origin, 0};
  Ball best{Vector3::Zero(), -1};
  const auto tried = [&](const Points& support) {
    const Ball ball = through(support, extent);
    if (ball.radius < 0 || (best.radius >= 0 && ball.radius >= best.radius)) return;
    for (const Vector3& p : points)
      if ((p - ball.center).norm() > ball.radius + 1e-10 * extent) return;
    best = ball;
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      tried({points[i], points[j]});
      for (std::size_t k = 0; k < j; ++k) {
        tried({points[i], points[j], points[k]});
        for (std::size_t l = 0; l < k; ++l) tried({points[i], points[j], points[k], points[l]});
      }
    }
  return {best.center + origin, best.radius};
}
