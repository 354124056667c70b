// The facts that fitters of several volumes share, in geometric words. Whoever shows them supplies colours and
// captions. Each fact lists its fields by name once, for every reader of traces (hash, JSON lines, inspector).
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The points with the least and the greatest coordinate along each axis.
template <class Scalar, int Dim>
struct ExtremesFound {
  static constexpr std::string_view kName = "extremes_found";
  std::array<Index, Dim> least{};
  std::array<Index, Dim> greatest{};
  SNUG_FIELDS(least, greatest);
};

/// Two points chosen as the first diameter. axis: 0 .. Dim - 1 for a coordinate axis, kNoIndex for another direction.
struct PairChosen {
  static constexpr std::string_view kName = "pair_chosen";
  Index a = kNoIndex, b = kNoIndex;
  int axis = kNoIndex;
  double distance = 0;
  SNUG_FIELDS(a, b, axis, distance);
};

template <class Scalar, int Dim>
struct MeanFound {
  static constexpr std::string_view kName = "mean_found";
  Vector<Scalar, Dim> mean;
  SNUG_FIELDS(mean);
};

/// covariance: in scene units squared, divided by n.
template <class Scalar, int Dim>
struct CovarianceFound {
  static constexpr std::string_view kName = "covariance_found";
  Vector<Scalar, Dim> mean;
  Matrix<Scalar, Dim> covariance;
  SNUG_FIELDS(mean, covariance);
};

/// Eigenvectors as columns, by rising eigenvalue; variances: the eigenvalues, in scene units squared.
template <class Scalar, int Dim>
struct AxesFound {
  static constexpr std::string_view kName = "axes_found";
  Vector<Scalar, Dim> mean;
  Matrix<Scalar, Dim> axes;
  Vector<Scalar, Dim> variances;
  SNUG_FIELDS(mean, axes, variances);
};

/// The last step of every run: the volume is the result, and these points support it.
struct Finished {
  static constexpr std::string_view kName = "finished";
  std::vector<Index> support;
  SNUG_FIELDS(support);
};

}  // namespace snug::fit
