#include "lesson/rows.hpp"

#include <Eigen/Geometry>

#include "geometry/tolerance.hpp"

namespace snug::lesson {
namespace {

bool are_axes(const Matrix<double, 3>& axes) {
  return (axes.transpose() * axes - Matrix<double, 3>::Identity()).cwiseAbs().maxCoeff() < tolerance::kAxesAsGiven &&
         axes.determinant() > 0;
}

}  // namespace

void RowWriter::operator()(const Vector<double, 3>& point) {
  for (int axis = 0; axis < dim_; ++axis) (*this)(point[axis]);
}

void RowWriter::operator()(const Matrix<double, 3>& axes) {
  for (int i = 0; i < (dim_ == 2 ? 1 : 3); ++i) (*this)(Vector<double, 3>(axes.col(i)));
}

void RowReader::operator()(double& number) {
  fits_ = fits_ && !left_.empty();
  if (!fits_) return;
  number = left_.front();
  left_ = left_.subspan(1);
}

void RowReader::operator()(Vector<double, 3>& point) {
  for (int axis = 0; axis < dim_; ++axis) (*this)(point[axis]);
}

void RowReader::operator()(Matrix<double, 3>& axes) {
  for (int i = 0; i < (dim_ == 2 ? 1 : 3); ++i) {
    Vector<double, 3> axis = Vector<double, 3>::Zero();
    (*this)(axis);
    axes.col(i) = axis;
  }
  if (dim_ == 2) axes.col(1) = Vector<double, 3>(-axes(1, 0), axes(0, 0), 0), axes.col(2) = Vector<double, 3>::UnitZ();
  fits_ = fits_ && are_axes(axes);
}

}  // namespace snug::lesson
