// The steps of the k-DOP's fitter.
#pragma once

#include <span>
#include <string_view>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/kdop.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The points that reach farthest along an axis of the k-DOP. slab: the index of that axis; min and max: the slab's
/// bounds, in scene units times the length of the axis.
struct SlabFound {
  static constexpr std::string_view kName = "slab_found";
  int slab = 0;
  Index least = kNoIndex, greatest = kNoIndex;
  double min = 0, max = 0;
  SNUG_FIELDS(slab, least, greatest, min, max);
};

template <class Scalar, int Dim>
using KdopStep = Step<Kdop<Scalar, Dim>, SlabFound, Finished>;

/// What fits k-DOPs.
[[nodiscard]] std::span<const Algorithm> rows_of(const Kdop<double, 3>*);

}  // namespace snug::fit
