// The types that everything shares: points and matrices of a scalar and a dimension.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace snug {

/// A position or a direction in scene units; unaligned, so that arrays of them are plain coordinates.
template <class Scalar, int Dim>
using Vector = Eigen::Matrix<Scalar, Dim, 1, Eigen::DontAlign>;

template <class Scalar, int Dim>
using Matrix = Eigen::Matrix<Scalar, Dim, Dim, Eigen::DontAlign>;

/// A point's index in its set.
using Index = std::int32_t;

inline constexpr Index kNoIndex = -1;

}  // namespace snug
