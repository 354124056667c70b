// The unit of the lengths in the tables of two boxes: a power of ten, so that large and small boxes fill no more room.
#pragma once

#include <string>

#include "lesson/boxes.hpp"

namespace snug::app {

struct TableUnit {
  int power = 0;  // of ten; 0 where lengths are written as they are
  [[nodiscard]] double in(double length) const;
  /// "units", or "10⁶ units".
  [[nodiscard]] std::string words() const;
};

/// Returns the power of ten below the boxes' size if that is at least 10,000 units or less than a hundredth.
[[nodiscard]] TableUnit table_unit(const lesson::BoxPair& pair);

}  // namespace snug::app
