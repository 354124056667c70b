// The facts that fitters of several volumes share, in geometric words. Whoever shows them supplies colours and
// captions. Each fact lists its fields by name once, for every reader of traces (hash, JSON lines, inspector).
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::fit {

/// The points with the least and the greatest coordinate along each axis.
template <class Scalar, int Dim>
struct ExtremesFound {
  static constexpr std::string_view kName = "extremes_found";
  std::array<Index, Dim> least{};
  std::array<Index, Dim> greatest{};
  static constexpr std::array<std::string_view, 2> kFields{"least", "greatest"};
  static auto tie(auto& own) { return std::tie(own.least, own.greatest); }
};

/// Two points chosen as the first diameter. axis: 0 .. Dim - 1 for a coordinate axis, kNoIndex for another direction.
struct PairChosen {
  static constexpr std::string_view kName = "pair_chosen";
  Index a = kNoIndex, b = kNoIndex;
  int axis = kNoIndex;
  double distance = 0;
  static constexpr std::array<std::string_view, 4> kFields{"a", "b", "axis", "distance"};
  static auto tie(auto& own) { return std::tie(own.a, own.b, own.axis, own.distance); }
};

template <class Scalar, int Dim>
struct MeanFound {
  static constexpr std::string_view kName = "mean_found";
  Vector<Scalar, Dim> mean;
  static constexpr std::array<std::string_view, 1> kFields{"mean"};
  static auto tie(auto& own) { return std::tie(own.mean); }
};

/// covariance: in scene units squared, divided by n.
template <class Scalar, int Dim>
struct CovarianceFound {
  static constexpr std::string_view kName = "covariance_found";
  Vector<Scalar, Dim> mean;
  Matrix<Scalar, Dim> covariance;
  static constexpr std::array<std::string_view, 2> kFields{"mean", "covariance"};
  static auto tie(auto& own) { return std::tie(own.mean, own.covariance); }
};

/// Eigenvectors as columns, by rising eigenvalue; variances: the eigenvalues, in scene units squared.
template <class Scalar, int Dim>
struct AxesFound {
  static constexpr std::string_view kName = "axes_found";
  Vector<Scalar, Dim> mean;
  Matrix<Scalar, Dim> axes;
  Vector<Scalar, Dim> variances;
  static constexpr std::array<std::string_view, 3> kFields{"mean", "axes", "variances"};
  static auto tie(auto& own) { return std::tie(own.mean, own.axes, own.variances); }
};

/// The last step of every run: the volume is the result, and these points support it.
struct Finished {
  static constexpr std::string_view kName = "finished";
  std::vector<Index> support;
  static constexpr std::array<std::string_view, 1> kFields{"support"};
  static auto tie(auto& own) { return std::tie(own.support); }
};

}  // namespace snug::fit
