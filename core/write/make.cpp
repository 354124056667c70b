#include "write/make.hpp"

#include "geometry/pose.hpp"

namespace snug::write {

Matrix<double, 3> random_rotation(Cases& cases) {
  const double w = cases.random.normal(), x = cases.random.normal(), y = cases.random.normal();
  return matrix_of(normalized({w, x, y, cases.random.normal()}));
}

}  // namespace snug::write
