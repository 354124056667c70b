// What rounding alone may make of a volume's size: less is nothing that could be compared.
#pragma once

#include <optional>
#include <string_view>

#include "fit/catalogue.hpp"

namespace snug::cost {

/// What rounding can do to the size of the volumes around one set of points.
struct Rounding {
  double length = 0;  // by how much a length of a volume may be off, scene units
  double size = 0;    // as long as none of them is

  /// How much the product of so many lengths may be off: 1 of a ball's radius, 2 of an area, 3 of a volume.
  [[nodiscard]] double of(int lengths) const;
  /// Below it such a product is nothing but rounding, of points that are flat, or nearly so.
  [[nodiscard]] double noise(int lengths) const;
  /// value over least, of which least is claimed to be the smallest. None where that is nothing but rounding. A value
  /// that is below it, but by no more than least may be off, is as small: 1. What is smaller still undercuts it, and is
  /// told.
  [[nodiscard]] std::optional<double> ratio(double value, double least, int lengths) const;
};

/// How many lengths a volume's size is a product of: a ball is compared by its radius.
[[nodiscard]] int lengths_of_size(std::string_view volume, int dim);

/// O(n).
[[nodiscard]] Rounding rounding_of(const AnyPointSet& points);

}  // namespace snug::cost
