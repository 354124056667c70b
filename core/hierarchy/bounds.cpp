#include "hierarchy/bounds.hpp"
#include "number/power_of_two.hpp"

namespace snug::hierarchy {

void normalize(Layout& layout) {
  if (layout.boxes.empty()) return;
  Box scene = layout.boxes.front();
  for (const Box& box : layout.boxes) scene = united(scene, box);
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, scene.high[i] - scene.low[i]);
  const int exponent = exponent_of(largest);
  layout.origin = scene.low;
  layout.unit = std::ldexp(1.0, exponent);
  const double inverse = std::ldexp(1.0, -exponent);
  for (Box& box : layout.boxes)
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = (box.low[i] - scene.low[i]) * inverse;
      box.high[i] = (box.high[i] - scene.low[i]) * inverse;
    }
}

}  // namespace snug::hierarchy
