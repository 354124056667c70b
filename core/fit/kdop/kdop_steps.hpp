// The steps of the k-DOP's fitter.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <tuple>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/kdop.hpp"

namespace snug::fit {

/// The points that reach farthest along an axis of the k-DOP. slab: the index of that axis; min and max: the slab's
/// bounds, in scene units times the length of the axis.
struct SlabFound {
  static constexpr std::string_view kName = "slab_found";
  int slab = 0;
  Index least = kNoIndex, greatest = kNoIndex;
  double min = 0, max = 0;
  static constexpr std::array<std::string_view, 5> kFields{"slab", "least", "greatest", "min", "max"};
  static auto tie(auto& own) { return std::tie(own.slab, own.least, own.greatest, own.min, own.max); }
};

template <class Scalar, int Dim>
using KdopStep = Step<Kdop<Scalar, Dim>, SlabFound, Finished>;

/// What fits k-DOPs.
[[nodiscard]] std::span<const Algorithm> rows_of(const Kdop<double, 3>*);

}  // namespace snug::fit
