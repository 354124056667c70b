#include "lesson/subjects/cloud/covariance_digits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/catalogue.hpp"
#include "number/double_double.hpp"

namespace snug::lesson {
namespace {

using Wide = std::array<DoubleDouble, 3>;

Wide wide_mean(const AnyPointSet& points) {
  Wide mean;
  const Index n = fit::count_of(points);
  for (Index i = 0; i < n; ++i)
    for (int axis = 0; axis < 3; ++axis) mean[axis] += fit::point_of(points, i)[axis];
  for (DoubleDouble& one : mean) one = one / DoubleDouble(static_cast<double>(n));
  return mean;
}

}  // namespace

int digits_right(const Matrix<double, 3>& found, const AnyPointSet& points) {
  constexpr int kMost = 16;
  const Wide mean = wide_mean(points);
  const Index n = fit::count_of(points);
  double largest = 0, error = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column <= row; ++column) {
      DoubleDouble sum;
      for (Index i = 0; i < n; ++i) {
        const Vector<double, 3> p = fit::point_of(points, i);
        sum += (DoubleDouble(p[row]) - mean[row]) * (DoubleDouble(p[column]) - mean[column]);
      }
      const DoubleDouble right = sum / DoubleDouble(static_cast<double>(n));
      largest = std::max(largest, std::abs(right.value()));
      error = std::max(error, std::abs((DoubleDouble(found(row, column)) - right).value()));
    }
  if (error == 0) return kMost;
  if (!(error < largest)) return 0;
  return std::min(kMost, static_cast<int>(-std::log10(error / largest)));
}

}  // namespace snug::lesson
