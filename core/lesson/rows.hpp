// Writes a row of numbers and reads it in the same order, exact to the last bit.
#pragma once

#include <span>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::lesson {

/// In 2-D a point has two numbers, and axes are written as the first axis only.
class RowWriter {
 public:
  explicit RowWriter(int dim) : dim_(dim) {}
  void operator()(double number) { row_.push_back(number); }
  void operator()(const Vector<double, 3>& point);
  void operator()(const Matrix<double, 3>& axes);
  [[nodiscard]] std::vector<double> take() { return std::move(row_); }

 private:
  int dim_;
  std::vector<double> row_;
};

class RowReader {
 public:
  RowReader(std::span<const double> row, int dim) : left_(row), dim_(dim) {}
  void operator()(double& number);
  void operator()(Vector<double, 3>& point);
  void operator()(Matrix<double, 3>& axes);
  /// Whether the row had exactly the numbers that were read, and its axes are unit, perpendicular and right-handed.
  [[nodiscard]] bool fits() const { return fits_ && left_.empty(); }

 private:
  std::span<const double> left_;
  int dim_;
  bool fits_ = true;
};

}  // namespace snug::lesson
