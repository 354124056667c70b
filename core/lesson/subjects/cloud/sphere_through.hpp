// On which side of the exact sphere through a support set a point is.
#pragma once

#include <optional>

#include "fit/catalogue.hpp"
#include "fit/fit.hpp"

namespace snug::lesson {

/// The sphere through a support set, with its centre in the set's affine hull, and never rounded.
class SphereThrough {
 public:
  SphereThrough(const AnyPointSet& points, const fit::Support& support) : points_(points), support_(support) {}
  /// -1 inside, 0 on it, +1 outside; none if the support set is affinely dependent, so that it has no such sphere.
  [[nodiscard]] std::optional<int> side(Index point) const;

 private:
  const AnyPointSet& points_;
  fit::Support support_;
};

}  // namespace snug::lesson
