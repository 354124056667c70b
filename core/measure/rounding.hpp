// How much rounding alone can change a volume's size: smaller differences mean nothing.
#pragma once

#include <optional>
#include <string_view>

#include "fit/catalogue.hpp"

namespace snug::cost {

/// The effect of rounding on the size of volumes around one set of points.
struct Rounding {
  double length = 0;  // the error bound of a volume's length, scene units
  double size = 0;    // longer than any of these lengths

  /// The error bound of a product of that many lengths: 1 for a ball's radius, 2 for an area, 3 for a volume.
  [[nodiscard]] double of(int lengths) const;
  /// A smaller product is only rounding: the points are flat, or nearly so.
  [[nodiscard]] double noise(int lengths) const;
  /// value / least, where least should be the smallest. None if least is only rounding. A value below least by no more
  /// than its error bound gives 1. A value smaller than that gives a ratio below 1, which shows that least is not the
  /// smallest.
  [[nodiscard]] std::optional<double> ratio(double value, double least, int lengths) const;
};

/// The number of lengths whose product is a volume's size; 1 for a ball, whose size is its radius.
[[nodiscard]] int lengths_of_size(std::string_view volume, int dim);

/// O(n).
[[nodiscard]] Rounding rounding_of(const AnyPointSet& points);

}  // namespace snug::cost
