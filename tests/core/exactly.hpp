// Scalars as rationals.
#pragma once

#include "core/exact.hpp"

namespace snug::exact {

template <class Scalar>
Rational exactly(Scalar value) {
  return Rational(static_cast<double>(value));
}

}  // namespace snug::exact
